(expected: 4:1 G10 is not supported: data setting)
T0101 S500 M3 F.2
G0 X50. Z5.
G10 P1 X0
M30
