(expected: 4:16 begins the pass beyond the start point)
T0101 S500 M3 F.2
G0 X50. Z5.
G90 X40. Z-20. R9.
M30
