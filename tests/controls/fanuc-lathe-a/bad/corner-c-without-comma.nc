(expected: 4:9 rodete does not follow letter C)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 X20. C1.
Z-9.
M30
