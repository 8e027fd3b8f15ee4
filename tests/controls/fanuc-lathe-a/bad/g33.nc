(expected: 4:1 G33 is not known to rodete)
T0101 S500 M3 F.2
G0 X50. Z5.
G33 Z-20. F2.
M30
