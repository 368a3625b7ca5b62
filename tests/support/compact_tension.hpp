// What a test of a compact specimen measures: its crack's length by its compliance.
#pragma once

#include <array>
#include <cmath>

namespace stria::test {

/// Crack length a/W from the compliance C = E' B v / P: Saxena and Hudak, Int. J. Fracture 14 (1978) 453, as in ASTM
/// E647 and E1820; for 0.2 <= x <= 0.975. `polynomial`: in u = 1 / (sqrt(C) + 1), the constant first.
inline double ct_crack_length(const std::array<double, 6>& polynomial, double C) {
    double sum = 0.0;
    for (std::size_t k = polynomial.size(); k-- > 0;) sum = sum / (std::sqrt(C) + 1.0) + polynomial[k];
    return sum;
}

/// With v the opening on the load line, or on the front face x = -W/4.
inline double ct_crack_length_from_load_line(double C) {
    return ct_crack_length({1.000196, -4.06319, 11.242, -106.043, 464.335, -650.677}, C);
}
inline double ct_crack_length_from_front_face(double C) {
    return ct_crack_length({1.001, -4.6695, 18.46, -236.82, 1214.9, -2143.6}, C);
}

}  // namespace stria::test
