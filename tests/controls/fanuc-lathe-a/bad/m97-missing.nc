(expected: 4:5 there is no block N99)
T0101 S500 M3 F.2
G0 X50. Z5.
M97 P99
M30
