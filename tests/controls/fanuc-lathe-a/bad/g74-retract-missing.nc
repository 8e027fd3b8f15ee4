(expected: 4:1 the first block of G74 is missing)
T0101 S500 M3 F.2
G0 X50. Z5.
G74 X40. Z0 P3000 Q1000 F.1
M30
