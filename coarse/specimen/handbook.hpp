// Handbook solutions of the specimens: stress intensity, compliance and limit load, per mm of thickness.
#pragma once

#include "common/case/case.hpp"

namespace stria::coarse {

/// Single-edge-notched plate, uniform remote tension, ends free to turn, any height above about one width; x = a/W.
/// F = K / (sigma sqrt(pi a)): Tada, Paris, Irwin, The Stress Analysis of Cracks Handbook; 0.5 % for every x.
double sent_factor(double x);

/// Middle-cracked plate, uniform remote tension, tall; x = 2a/W with the half length a.
/// F = K / (sigma sqrt(pi a)): Tada's formula of the same handbook; 0.1 % for every x.
double mt_factor(double x);

/// Compact specimen; x = a/W. f = K B sqrt(W) / P: Srawley (1976), ASTM E399, E647, E1820; 0.5 % for x >= 0.2.
double ct_factor(double x);

/// Stress intensity, MPa sqrt(mm), under the resultant `load`, N per mm of thickness.
double sent_K(double width, double a, double load);
double mt_K(double width, double a, double load);
double ct_K(double width, double a, double load);

/// Compact specimen: the compliance C = E' B v / P at the crack length x = a/W, with v the opening on the load line or
/// on the front face x = -W/4. The inverse of the crack length that Saxena and Hudak (1978) give by a compliance, as in
/// ASTM E647 and E1820, for 0.2 <= x <= 0.975. Solved for to 1e-12, so as accurate as their polynomials (6e-4 in x).
double ct_load_line_compliance(double x);
double ct_front_face_compliance(double x);

/// Limit load of a non-hardening material (von Mises), N per mm of thickness.
///   SENT, ends free to turn: plane strain Miller (1988) with Ewing and Richards (1974) for x > 0.545, plane stress
///   Kumar, German and Shih (EPRI NP-1931, 1981); CT: Miller (1988); M(T): net section, exact.
double sent_limit_load(double width, double a, double yield_stress, PlaneState plane);
double mt_limit_load(double width, double a, double yield_stress, PlaneState plane);
double ct_limit_load(double width, double a, double yield_stress, PlaneState plane);

}  // namespace stria::coarse
