(expected: 4:9 rodete does not follow letter E)
T0101 S500 M3 F.2
G0 X50. Z5.
G32 Z1. E2.
M30
