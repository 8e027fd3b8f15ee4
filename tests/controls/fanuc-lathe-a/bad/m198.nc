(expected: 4:1 rodete does not follow M198)
T0101 S500 M3 F.2
G0 X50. Z5.
M198 P1
M30
