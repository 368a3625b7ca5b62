"""The case of tests that look at what a run has written: a kinked crack that grows, flows, closes in compression and slides."""


def closing_plate(at_tip, beyond):
    """Elements of these sizes about the tip, mm."""
    return f"""
title = "A plate that closes"
units = "N-mm-MPa"
mesh = {{ specimen = "sent", width = 50.0, height = 100.0, size = 4.0, grading = [ {{ at = [[15.0, 52.0]], size = {at_tip}, outer_size = {beyond}, radius = 4.0 }} ] }}
material = {{ young = 200e3, poisson = 0.3, yield_stress = 300.0, kinematic = [ {{ C = 4000.0 }} ] }}
crack = [ {{ points = [[0.0, 50.0], [9.0, 50.0], [15.0, 52.0]], contact = {{ friction = 0.3 }} }} ]
boundary = [ {{ on = "top", displacement = ["free", 1.0] }}, {{ on = "bottom", displacement = ["free", 0.0] }} ]
load = {{ steps = 16, blocks = [ {{ cycles = 3, max = 0.04, ratio = -1.0 }} ] }}
growth = {{ increment = 0.4, direction = "straight" }}
output = {{ faces = "cycles", fields = "cycles" }}
"""
