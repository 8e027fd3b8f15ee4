(expected: 4 thread without its lead F)
T0101 S500 M3 F.2
G0 X50. Z5.
G32 Z-20.
M30
