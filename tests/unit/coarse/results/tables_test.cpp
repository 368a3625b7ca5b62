// Rows and columns of the tables a run leaves, and its summary.
#include "coarse/results/tables.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coarse/results/rows.hpp"
#include "coarse/results/summary.hpp"
#include "tests/support/load_cases.hpp"

namespace stria::coarse {
namespace {

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
    return text;
}

TEST(Tables, HaveTheColumnsUsersKnow) {
    EXPECT_EQ(joined(history_columns()),
              "increment,cycle,load_factor,load,displacement,tip,x,y,a,K_I,K_II,J,CMOD,CTOD,newton_iterations,"
              "contact_length,plastic_zone,dissipation,plastic_zone_axis,T_stress,J_spread,K_spread,external_work,"
              "stored_energy,released_energy,balance_error,frictional_dissipation,opening");
    EXPECT_EQ(joined(cycle_columns()),
              "cycle,tip,a,da,dN,K_max,K_min,K_op,K_cl,U,dK_eff,J_max,CTOD_range,forward_zone,cyclic_zone,"
              "newton_iterations,fine_points,fine_unknowns,wall_s,forward_zone_axis,cyclic_zone_axis,K_op_contact,"
              "K_op_offset,K_op_tension,opening_range,N,K_initial");
    EXPECT_EQ(joined(closure_columns()), "cycle,tip,distance,K_op,K_cl,K_slip,K_slip_unloading");
    EXPECT_EQ(joined(face_columns()), "increment,crack,s,x,y,opening,slip,pressure,shear,status");
}

TEST(Tables, PutValuesUnderTheirColumns) {
    HistoryRow row;
    row.K_I = 42.0;
    EXPECT_EQ(std::get<double>(cells_of(row)[9]), 42.0);
    EXPECT_TRUE(std::holds_alternative<std::monostate>(cells_of(row)[5]));  // no tip
    row.tip = 1;
    EXPECT_EQ(std::get<std::int64_t>(cells_of(row)[5]), 1);

    coupling::FaceSample sample;
    sample.pressure = 8.0;
    sample.status = 2;
    const std::vector<Cell> cells = cells_of(face_row(40, sample));
    EXPECT_EQ(std::get<std::int64_t>(cells[0]), 40);
    EXPECT_EQ(std::get<double>(cells[7]), 8.0);
    EXPECT_EQ(std::get<std::int64_t>(cells[9]), 2);
}

TEST(Tables, LeaveSlipEmptyWhereNobodyMeasuresIt) {
    Case input;
    input.closure.profile = {0.5};
    const ClosureMeter closure(input.closure, {300.0}, input.cracks, {500.0});
    Increment increment;
    increment.cycles.resize(1);
    increment.cycles[0].contact = {{.K_op = 80.0}, {.K_op = 90.0}};
    EXPECT_TRUE(std::isnan(closure_rows(increment, 0, closure).at(1).K_slip));
    increment.cycles[0].K_slip = {60.0, 70.0};
    EXPECT_EQ(closure_rows(increment, 0, closure).at(1).K_slip, 70.0);
}

TEST(Tables, SayHowLoadCasesLoadAndWhereAWheelIs) {
    Case input;
    input.load.steps = 2;
    input.load_cases = {test::dead_load("dead", 3.0)};
    input.boundaries.resize(2);
    input.boundaries[1].travelling = TravellingPressure{.from = -8.0, .to = 8.0};
    EXPECT_EQ(joined(load_columns(input)),
              "increment,cycle,load_factor,dead,position_1,work,work_dead,work_position_1");
    Increment increment;
    increment.number = 7;
    increment.load_factor = 2.0;
    increment.step.target.cases = Eigen::Vector4d(3.0, 0.0, 0.75, 0.25);
    const std::vector<Cell> cells = load_cells(input, increment);
    EXPECT_EQ(std::get<std::int64_t>(cells[0]), 7);
    EXPECT_EQ(std::get<double>(cells[2]), 2.0);
    EXPECT_EQ(std::get<double>(cells[3]), 3.0);
    EXPECT_EQ(std::get<double>(cells[4]), 2.0);  // a quarter of the way from 0 to 8
    increment.work.external = 10.0;
    increment.work.by_cases = Eigen::Vector4d(1.0, 0.5, 1.5, 2.0);
    const std::vector<Cell> later = load_cells(input, increment);
    for (const auto& [column, work] : {std::pair(5U, 5.0), {6U, 1.0}, {7U, 4.0}})
        EXPECT_EQ(std::get<double>(later[column]), work);
    increment.step.target.cases.resize(0);
    EXPECT_TRUE(std::isnan(std::get<double>(load_cells(input, increment)[4])));
}

TEST(SummaryJson, HoldsItsKeys) {
    Summary summary;
    summary.status = RunStatus::Done;
    summary.last.resize(2);
    summary.last[0].tip = 0;
    const std::string text = text_of(to_json(summary));
    for (const char* key :
         {"status", "version", "mode", "ranks", "coarse_unknowns", "interface_unknowns", "fine_unknowns", "fine_points",
          "timing", "setup", "coarse_factor", "fine_constitutive", "fine_contact", "fine_factor", "exchange", "output",
          "total", "newton_iterations", "tips"}) {
        EXPECT_NE(text.find('"' + std::string(key) + "\":"), std::string::npos) << key;
    }
}

}  // namespace
}  // namespace stria::coarse
