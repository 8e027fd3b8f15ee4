(expected: 5:9 PS0051: a line of the corner has no length)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 X20.
G1 X20. ,R3.
Z-9.
M30
