(expected: 4:16 Q is not supported: a thread's start angle)
T0101 S500 M3 F.2
G0 X50. Z5.
G32 Z-20. F1.5 Q180000
M30
