(expected: 4:1 M98 without P)
T0101 S500 M3 F.2
G0 X50. Z5.
M98
M30
