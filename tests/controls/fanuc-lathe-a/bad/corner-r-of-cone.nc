(expected: 4:13 PS0054: the corner is not between a line along one axis)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 X20. Z2. R1.
Z-9.
M30
