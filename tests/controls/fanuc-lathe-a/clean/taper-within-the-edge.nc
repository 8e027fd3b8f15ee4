(stock D50xL120)
(50 degrees, which the second edge at 52 degrees lets through)
O1
G50 S2500
T0202
G97 S600 M3
M8
G0 X46. Z2.
G1 Z-10. F0.2
X40. Z-12.52
Z-20.
X54.
G0 X100. Z50. M9
M30
