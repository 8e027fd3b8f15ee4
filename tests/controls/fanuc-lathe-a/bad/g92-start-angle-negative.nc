(expected: 4:21 Q-90000 is not the start angle of a thread)
T0101 S500 M3 F.2
G0 X50. Z5.
G92 X48. Z-20. F1.5 Q-90000
M30
