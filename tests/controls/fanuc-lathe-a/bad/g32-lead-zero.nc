(expected: 4:11 thread with lead 0)
T0101 S500 M3 F.2
G0 X50. Z5.
G32 Z-20. F0
M30
