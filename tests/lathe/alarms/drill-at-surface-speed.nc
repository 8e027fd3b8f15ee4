(stock D60xL100)
(alarms 156@10)
(G97 forgotten after turning: on the axis the drill runs at the limit of the spindle)
O1
G50 S2500
T0505
G96 S30 M3
M8
G0 X0. Z2.
G1 Z-20. F0.1
G0 Z2.
G0 X100. Z50.
M30
