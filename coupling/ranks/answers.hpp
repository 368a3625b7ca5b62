// Answers of several fine components that work side by side.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "coupling/fine_scale.hpp"

namespace stria::coupling {

/// Reads the answer of each, by its place, also where one is a failure: nobody is left in mid-conversation. As they
/// come: what one has found is unpacked while another still computes. Throws the first failure when all are read.
void for_each_answer(const std::vector<FineScale*>& asked, const std::function<void(std::size_t)>& read);

}  // namespace stria::coupling
