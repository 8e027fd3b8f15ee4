(expected: 4:20 rodete does not follow Q, a thread's start angle, in G34)
T0101 S500 M3 F.2
G0 X50. Z5.
G34 Z-20. F1.5 K.1 Q180000
M30
