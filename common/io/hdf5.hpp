// HDF5 files as values: files, groups, datasets and attributes of plain numbers. The library itself stays in hdf5.cpp.
#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stria::hdf5 {

template <class T>
concept Storable = std::same_as<T, double> || std::same_as<T, std::int32_t> || std::same_as<T, std::int64_t> ||
    std::same_as<T, std::uint64_t> || std::same_as<T, std::int8_t> || std::same_as<T, std::uint8_t>;

/// A group of an open file, which stays open as long as one of its groups lives. Every failure throws
/// std::runtime_error with the name of what could not be read or written.
class Group {
public:
    [[nodiscard]] Group create_group(const std::string& name);
    [[nodiscard]] Group group(const std::string& name) const;
    [[nodiscard]] bool contains(const std::string& name) const;

    /// Row-major; without a shape the dataset is a vector.
    template <Storable T>
    void write(const std::string& name, std::span<const T> values, const std::vector<std::size_t>& shape = {});
    template <Storable T> [[nodiscard]] std::vector<T> read(const std::string& name) const;
    [[nodiscard]] std::vector<std::size_t> shape(const std::string& name) const;

    template <Storable T> void write_attribute(const std::string& name, std::span<const T> values);
    template <Storable T> [[nodiscard]] std::vector<T> read_attribute(const std::string& name) const;

    /// Text of fixed length, ASCII as VTK wants it.
    void write_text(const std::string& name, std::string_view text);
    [[nodiscard]] std::string read_text(const std::string& name) const;

private:
    struct Handle;
    explicit Group(std::shared_ptr<const Handle> handle) : handle_(std::move(handle)) {}
    std::shared_ptr<const Handle> handle_;

    friend std::string image_of(const std::function<void(Group&)>& fill);
    friend Group read_file(const std::filesystem::path& path);
};

/// The bytes of a file, made in memory by filling its root group: the library cannot let go of a file of its own that a
/// full disk refuses.
std::string image_of(const std::function<void(Group&)>& fill);

/// The file is there whole or not at all. Throws FileFailure.
void write_file(const std::filesystem::path& path, const std::function<void(Group&)>& fill);

/// Root group of an existing file, for reading.
Group read_file(const std::filesystem::path& path);

}  // namespace stria::hdf5
