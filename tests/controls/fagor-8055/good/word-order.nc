%WORD-ORDER,MX,
;F S T D M behind the axes: examples manual, page 48, without its G43
N10 G71 G17 G94
N20 G0 G90 X0 Y0 Z20 F200 S1500 T7 D7 M3 M41
;nine axes in their order: programming manual, page 47
/1 N30 G1 X1 Y2 Z3 U4 V5 W6 A7 B8 C9 F100 M8
N40 G1 X10 Y0
;words of an arc stand where they are
N50 G2 X20 Y0 I5 J0 F150
N60 G2 X30 I5 Y0 J0
N70 G2 I-5 J0 X20 Y0 S1200 M3
N80 G4 K50
;S is the angle of M19 and the speed of M45
N90 M19 S90
N100 M45 S500
N110 G0 X0 B0 C0 T2 M5 M9 M30
