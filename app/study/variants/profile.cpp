#include "app/study/variants/profile.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "common/index.hpp"

namespace stria::study {

namespace {

double value_at(const Profile& profile, double s) {
    const auto above = std::ranges::lower_bound(profile.s, s);
    if (above == profile.s.begin()) return profile.opening.front();
    if (above == profile.s.end()) return profile.opening.back();
    const auto k = at(above - profile.s.begin());
    const double weight = (s - profile.s[k - 1]) / (profile.s[k] - profile.s[k - 1]);
    return std::lerp(profile.opening[k - 1], profile.opening[k], weight);
}

/// Integral over s by the trapezoidal rule on the stations.
double integral(const std::vector<double>& s, const auto& f) {
    double sum = 0.0;
    for (std::size_t k = 1; k < s.size(); ++k) sum += 0.5 * (s[k] - s[k - 1]) * (f(k - 1) + f(k));
    return sum;
}

}  // namespace

double mean_opening(const Profile& profile) {
    if (profile.s.size() < 2) return missing;
    const double length = profile.s.back() - profile.s.front();
    return integral(profile.s, [&](std::size_t k) { return profile.opening[k]; }) / length;
}

double relative_error(const Profile& profile, const Profile& reference) {
    if (profile.s.size() < 2 || reference.s.size() < 2) return missing;
    // The stations of both: a fine profile against a coarse reference is not judged at the reference's few points.
    std::vector<double> s;
    std::ranges::set_union(profile.s, reference.s, std::back_inserter(s));
    const auto squared = [](double x) { return x * x; };
    const double difference =
        integral(s, [&](std::size_t k) { return squared(value_at(profile, s[k]) - value_at(reference, s[k])); });
    const double size = integral(s, [&](std::size_t k) { return squared(value_at(reference, s[k])); });
    return size > 0.0 ? std::sqrt(difference / size) : missing;
}

}  // namespace stria::study
