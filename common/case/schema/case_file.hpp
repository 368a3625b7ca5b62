// Reads, checks and writes case files, and explains their keys.
#pragma once

#include "common/case/case.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace stria {

/// The case at `path`, checked as far as that goes without a mesh. An override is "key=value" with a TOML value:
/// "fine.beta=4", "crack.0.contact.friction=0.2"; a value that is no TOML is taken as text. Throws CaseError.
Case read_case(const std::string& path, const std::vector<std::string>& overrides = {});

/// Every key with its value, as a case file that gives an equal Case when read.
std::string resolved_toml(const Case& scene);

/// Changes with every value of the case.
std::uint64_t digest(const Case& scene);

/// The reference of one key, of a section or (empty) of all. Throws CaseError where there is no such key.
std::string explain(const std::string& key);
std::string case_reference_markdown();

}  // namespace stria
