// Scenes whose runs are stopped between two increments: wherever a run remembers something of its own.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "tests/support/sent_analysis.hpp"

namespace stria::test {

struct StoppedRun {
    const char* name;
    std::vector<std::string> settings;
    int stop;  // increment after which the analysis is stopped
    void (*change)(Case&) = [](Case&) {};

    friend std::ostream& operator<<(std::ostream& out, const StoppedRun& run) { return out << run.name; }
};

namespace stopped {

/// Flow and contact; stopped while the faces close.
inline const StoppedRun still{
    "Still", {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=16", "solver.tolerance=1e-12"}, 13};

/// Its second cycle, which is predicted from the first.
inline const StoppedRun again{"Again",
                              {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=16", "solver.tolerance=1e-12",
                               "load.blocks=[{cycles=2, max=50.0, ratio=-1.0}]"},
                              30};

/// A zone that has been extended, and is once more where the load rises beyond what it was.
inline const StoppedRun extended{"Extended",
                                 {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=12", "solver.tolerance=1e-12",
                                  "fine.radius=0.5",
                                  "load.blocks=[{cycles=1, max=40, ratio=-1}, {cycles=1, max=60, ratio=0}]"},
                                 14};

/// A crack that has grown through elements and grows again, with a tip function that freezes.
inline const StoppedRun growing{"Growing",
                                {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=12", "solver.tolerance=1e-12",
                                 "fine.enrichment=single", "load.blocks=[{cycles=3, max=50.0, ratio=-1.0}]",
                                 "growth.increment=0.3"},
                                27};

/// A slot inside: growth at its first end leaves the slot behind, and before it are new faces.
inline const StoppedRun slotted{"Slotted",
                                {"mesh.grading=[{at=[[15.0,100.0],[25.0,100.0]],size=0.6,outer_size=1.2,radius=3.0}]",
                                 "mesh.size=12.5", "load.steps=6", "solver.tolerance=1e-12",
                                 "crack.0.points=[[15.0,100.03],[25.0,100.03]]", "crack.0.notch=10.0",
                                 "load.blocks=[{cycles=4, max=80.0, ratio=-1.0}]", "growth.increment=0.4"},
                                20};

/// The same in fewer and larger elements and increments: one matrix takes its time.
inline const StoppedRun small{"Small",
                              {mesh_at_tip(0.6), "mesh.size=12.5", "load.steps=6", "solver.tolerance=1e-12",
                               "load.blocks=[{cycles=3, max=50.0, ratio=-1.0}]", "growth.increment=0.4"},
                              13};

/// Within a zone that holds its way for now: the whole run keeps its structure's factor, what resumes makes it anew.
inline const StoppedRun within{"Within",
                               {"mesh.grading=[]", "mesh.size=7.4", "fine.refine=8", "fine.growth=0.25", "load.steps=6",
                                "load.blocks=[{cycles=4, max=50.0, ratio=-1.0}]", "growth.increment=0.2"},
                               20};

/// Small elements follow the tip: some have been split before the stop, and others are after it.
inline const StoppedRun followed{"Followed",
                                 {"mesh.grading=[]", "mesh.size=7.4", "fine.refine=8", "fine.radius=1.0",
                                  "load.steps=6", "solver.tolerance=1e-12",
                                  "load.blocks=[{cycles=5, max=50.0, ratio=-1.0}]", "growth.increment=0.6"},
                                 20};

/// An inclined crack whose faces slide against friction; stopped while they do, and while K_slip is measured.
inline const StoppedRun sliding{"Sliding",
                                {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=16", "solver.tolerance=1e-12",
                                 "closure.profile=[1.0]", "crack.0.points=[[0.0, 88.0], [20.0, 100.0]]",
                                 "crack.0.contact.friction=0.3", "load.blocks=[{cycles=2, max=50.0, ratio=-1.0}]"},
                                31};

/// The same crack while it grows: what has slid is on functions that the next tip freezes.
inline const StoppedRun sliding_growing{"SlidingGrowing",
                                        {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=12", "solver.tolerance=1e-12",
                                         "closure.profile=[1.0]", "crack.0.points=[[0.0, 80.0], [20.0, 100.0]]",
                                         "crack.0.contact.friction=0.3",
                                         "load.blocks=[{cycles=3, max=50.0, ratio=-1.0}]", "growth.increment=0.3"},
                                        27};

/// Flow in two metals and a strip that never yields; the crack grows out of the one into the other.
inline const StoppedRun layered{
    "Layered",
    {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=12", "solver.tolerance=1e-12",
     "load.blocks=[{cycles=3, max=50.0, ratio=-1.0}]", "growth.increment=0.3",
     "region=[{outline=[[20.4,0.0],[23.0,200.0]], material={young=120e3, poisson=0.34, yield_stress=150.0, "
     "kinematic=[{C=5e3, gamma=30.0}]}, initial_stress={yy=20.0}}, {outline=[[23.0,0.0],[50.0,200.0]], "
     "material={young=300e3, poisson=0.2}}]",
     "initial_stress={sigma_y={at=[0.0,12.5,25.0,37.5,50.0], stress=[20.0,0.0,-20.0,0.0,20.0]}}"},
    27};

/// Under a dead load, a shear behind the tension and a wheel that rolls over the side, while the crack grows.
inline const StoppedRun loaded{
    "Loaded",
    {mesh_at_tip(0.6), "mesh.size=12.5", "load.steps=6", "solver.tolerance=1e-12",
     "load.blocks=[{cycles=3, max=35.0, ratio=-1.0}]", "growth.increment=0.4",
     "load_case=[{name='dead', constant=15.0}, {name='shear', factor=0.3, phase=90.0}]",
     "boundary=[{on='top', traction=[0.0,1.0]}, {on='top', traction=[0.0,1.0], case='dead'}, "
     "{on='bottom', displacement=[0.0,0.0]}, {on='top', traction=[1.0,0.0], case='shear'}, "
     "{on='left', origin=[0.0,100.0], travelling={p0=40.0, half_width=3.0, from=-12.0, to=12.0}}]"},
    13};

/// Half way of an increment that was halved.
inline const StoppedRun halved{
    "Halved",
    {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=4", "solver.tolerance=1e-6", "solver.max_iterations=5"},
    6};

/// Where the load factor is found.
inline const StoppedRun displaced{"Displaced",
                                  {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=8", "solver.tolerance=1e-12",
                                   "load.control=displacement", "load.blocks=[{cycles=2, max=0.06, ratio=-1.0}]"},
                                  14};

/// Likewise beside a dead load, stopped where that has come on: the displacement goes on from where the boundary is.
inline const StoppedRun displaced_beside{
    "DisplacedBesideADeadLoad",
    {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=8", "solver.tolerance=1e-12", "load.control=displacement",
     "load.blocks=[{cycles=1, max=0.06, ratio=-1.0}]", "load_case=[{name='dead', constant=25.0}]",
     "boundary=[{on='top', traction=[0.0,1.0]}, {on='top', traction=[0.0,1.0], case='dead'}, "
     "{on='bottom', displacement=[0.0,0.0]}]"},
    4};

/// Likewise on the way from where an initial stress has moved the boundary to a first displacement of zero.
inline const StoppedRun displaced_by_stress{
    "DisplacedByAnInitialStress",
    {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=8", "solver.tolerance=1e-12", "load.control=displacement",
     "load.blocks=[{cycles=1, max=0.0, min=-0.02}]",
     "initial_stress={sigma_y={at=[0.0,25.0,50.0], stress=[100.0,-100.0,100.0]}}"},
    3};

/// No zone at all.
inline const StoppedRun elastic{"Elastic",
                                {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=4",
                                 "load.blocks=[{cycles=3, max=50.0, ratio=0.0}]", "growth.increment=0.4"},
                                9,
                                [](Case& input) {
                                    input.material.yield_stress.reset();
                                    input.material.kinematic.clear();
                                    input.cracks[0].contact.reset();
                                }};

/// A tip that opens as the load falls: no opening behind it is known before it has grown, and then all the increments
/// of the half cycle that begins are chosen by it.
inline const StoppedRun lengthened{
    "Lengthened",
    {"mesh.grading=[{at=[[2.0,100.0]],size=0.2,outer_size=0.8,radius=2.0}]", "mesh.size=12.5", "load.steps=auto",
     "crack.0.points=[[0.0,100.0],[2.0,100.0]]", "closure.distance=2.1", "growth.increment=0.2",
     "load.blocks=[{cycles=2, max=100.0, min=-120.0}]",
     "boundary=[{on='top', traction=[0.0,-1.0]}, {on='bottom', displacement=[0.0,0.0]}]"},
    19};

}  // namespace stopped

}  // namespace stria::test
