(stock D50xL120)
(a finishing cut back along the part, all at feed: the way back takes the surface that the second edge stood in)
O1
G50 S2500
T0101
G97 S600 M3
M8
G0 X46. Z2.
G1 Z-20. F0.2
X45.5
Z2.
G0 X100. Z50. M9
M30
