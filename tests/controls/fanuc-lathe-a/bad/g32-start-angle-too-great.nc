(expected: 4:16 Q400000 is not the start angle of a thread)
T0101 S500 M3 F.2
G0 X50. Z5.
G32 Z-20. F1.5 Q400000
M30
