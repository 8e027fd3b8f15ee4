(expected: 4:8 rodete does not follow letter C)
T0101 S500 M3 F.2
G0 X50. Z5.
G0 X1. C90.
M30
