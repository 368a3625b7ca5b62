// Files that are there whole or not at all: written under a temporary name beside their own, synced, renamed.
#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <string_view>

namespace stria {

/// Calls `write` with the temporary path and puts the file it leaves there in the place of `path`. If `write` throws,
/// or the disk refuses (FileFailure), an earlier file at `path` stays as it was.
void write_whole(const std::filesystem::path& path, const std::function<void(const std::filesystem::path&)>& write);

/// Waits until the disk holds what a file has. Throws FileFailure.
void sync_file(const std::filesystem::path& path);

/// The texts one behind the other. `earlier`: where to keep the file that was there; nowhere unless told.
void write_whole_texts(const std::filesystem::path& path, std::initializer_list<std::string_view> texts,
                       const std::filesystem::path& earlier = {});
void write_whole_text(const std::filesystem::path& path, std::string_view text);

}  // namespace stria
