// Runs of the shipped edge crack that each mode is asked for: with flow, contact, growth, small elements and sliding.
#pragma once

#include <string>
#include <vector>

#include "tests/support/sent_analysis.hpp"

namespace stria::test {

/// Plastic flow in tension, contact in compression, 24 increments.
inline const std::vector<std::string> small_scene{mesh_at_tip(0.3), "mesh.size=10.0", "load.steps=8",
                                                  "solver.tolerance=1e-12"};

/// The same on large elements that the zone splits; the crack runs through their middles, and from large into small.
inline const std::vector<std::string> refined_scene{"mesh.grading=[]", "mesh.size=7.4", "fine.refine=16",
                                                    "fine.growth=0.25", "solver.tolerance=1e-12"};

/// The zone of the first, begun too small: new elements join while others have a history.
inline const std::vector<std::string> extended_scene{mesh_at_tip(0.3), "mesh.size=10.0", "fine.radius=1.0",
                                                     "solver.tolerance=1e-12"};

/// The crack grows through elements and across their edges, at the maximum of two cycles.
inline const std::vector<std::string> growing_scene{
    mesh_at_tip(0.4),         "mesh.size=10.0",
    "solver.tolerance=1e-12", "load.blocks=[{cycles=2, max=50.0, ratio=-1.0}]",
    "load.steps=8",           "growth.increment=0.25"};

/// Small elements follow the tip of a crack that grows.
inline const std::vector<std::string> following_scene{"mesh.grading=[]",
                                                      "mesh.size=7.4",
                                                      "fine.refine=8",
                                                      "fine.radius=1.0",
                                                      "solver.tolerance=1e-12",
                                                      "load.steps=6",
                                                      "load.blocks=[{cycles=3, max=50.0, ratio=-1.0}]",
                                                      "growth.increment=0.6"};

/// An inclined crack whose faces slide against friction while they are closed.
inline const std::vector<std::string> sliding_scene{
    "mesh.grading=[{at=[[20.0,100.0]], size=0.3, outer_size=0.6, radius=3.0, growth=0.25}]",
    "mesh.size=10.0",
    "solver.tolerance=1e-12",
    "crack.0.points=[[0.0, 88.0], [20.0, 100.0]]",
    "crack.0.contact.friction=0.3",
    "load.steps=8",
    "load.blocks=[{cycles=1, max=50.0, ratio=-1.0}]"};

/// The ends are held, and nothing is left to the structure.
inline const std::vector<std::string> whole_scene{
    "mesh.grading=[]",
    "mesh.size=12.4",
    "fine.radius=300.0",
    "boundary=[{on=\"top\", displacement=[0.0, 1e-3]}, {on=\"bottom\", displacement=[0.0, 0.0]}]",
    "load.steps=12",
    "load.blocks=[{cycles=1, max=200.0, ratio=-1.0}]",
    "solver.tolerance=1e-12"};

/// The plastic zone reaches into a weaker metal ahead, and from there into a strip that never yields. The weaker one
/// has a misfit, and the plate a stress across it before any load.
inline const std::vector<std::string> layered_scene{
    mesh_at_tip(0.6),
    "mesh.size=10.0",
    "load.steps=12",
    "solver.tolerance=1e-12",
    "region=[{outline=[[21.0,0.0],[23.0,200.0]], initial_stress={yy=25.0, xx=10.0}, material={young=120e3, "
    "poisson=0.34, yield_stress=150.0, isotropic={law='voce', Q=80.0, b=20.0}, kinematic=[{C=5e3, gamma=30.0}]}}, "
    "{outline=[[23.0,0.0],[50.0,90.0],[50.0,200.0],[23.0,200.0]], material={young=300e3, poisson=0.2}}]",
    "initial_stress={sigma_y={at=[0.0,12.5,25.0,37.5,50.0], stress=[20.0,0.0,-20.0,0.0,20.0]}}"};

/// Under a dead load, a shear behind the tension, an end that a load case moves, and a wheel on the side of the zone
/// that rolls over the mouth of the crack.
inline const std::vector<std::string> loaded_scene{
    mesh_at_tip(0.6),
    "mesh.size=10.0",
    "load.steps=12",
    "solver.tolerance=1e-12",
    "fine.radius=30.0",
    "load.blocks=[{cycles=1, max=35.0, min=-75.0}]",
    "load_case=[{name='dead', constant=15.0}, {name='shear', factor=0.3, phase=90.0}, {name='moved', factor=1e-3}]",
    "boundary=[{on='top', traction=[0.0,1.0]}, {on='top', traction=[0.0,1.0], case='dead'}, "
    "{on='bottom', displacement=[0.0,0.0]}, {on='bottom', displacement=[0.0,-1.0], case='moved'}, "
    "{on='top', traction=[1.0,0.0], case='shear'}, {on='left', origin=[0.0,100.0], travelling={p0=40.0, "
    "half_width=3.0, friction=0.2, from=-12.0, to=12.0}}]"};

}  // namespace stria::test
