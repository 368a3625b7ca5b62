// Lists of the ranks end to end.
#pragma once

namespace stria::coupling {

/// The entries of `part` behind those of `whole`.
void append(auto& whole, const auto& part) { whole.insert(whole.end(), part.begin(), part.end()); }

}  // namespace stria::coupling
