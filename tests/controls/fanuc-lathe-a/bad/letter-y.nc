(expected: 4:4 rodete does not follow letter Y)
T0101 S500 M3 F.2
G0 X50. Z5.
G0 Y1.
M30
