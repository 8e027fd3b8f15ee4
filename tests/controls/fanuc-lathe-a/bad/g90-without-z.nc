(expected: 4:1 Z missing in G90)
T0101 S500 M3 F.2
G0 X50. Z5.
G90 X40.
M30
