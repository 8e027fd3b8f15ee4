(expected: 4:12 rodete does not follow letter J)
T0101 S500 M3 F.2
G0 X50. Z5.
G2 X40. Z0 J5.
M30
