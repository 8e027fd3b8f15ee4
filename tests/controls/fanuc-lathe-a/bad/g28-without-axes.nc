(expected: 4:1 G28 without axes)
T0101 S500 M3 F.2
G0 X50. Z5.
G28
M30
