#include "app/report/time_chart.hpp"

namespace stria::report {

charts::BarChart time_chart(const std::string& title) {
    return {.title = title,
            .x_label = "s",
            .parts = {"setup", "points", "contact", "fronts", "wire", "coarse solve", "output"}};
}

charts::Bar time_bar(const std::string& name, const Seconds& seconds) {
    const double points = seconds("fine_constitutive"), contact = seconds("fine_contact");
    const double fronts = seconds("fine_factor");
    return {.name = name,
            .lengths = {seconds("mesh") + seconds("setup"), points, contact, fronts,
                        seconds("exchange") - points - contact - fronts, seconds("coarse_solve"), seconds("output")}};
}

}  // namespace stria::report
