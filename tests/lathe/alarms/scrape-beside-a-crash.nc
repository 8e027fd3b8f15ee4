(stock D60xL100)
(alarms 101@11)
(a blade leaves no wedge: its relief of 0.3 mm cuts the wall in rapid, as the drop back into the groove does)
O1
G50 S2500
T0303
G97 S600 M3
M8
G0 X64. Z-20.
G75 R0.5
G75 X50. Z-20. P2000 R0.3 F0.08
M30
