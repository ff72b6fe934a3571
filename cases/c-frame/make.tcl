# Makes press.step, the assembly of a C-frame eccentric press of 250 kN:  occt-draw -b -f make.tcl  (packages occt-draw and
# libocct-draw-dev). Lengths in mm, x to the right, y up, z along the crankshaft from the back to the front; origin: centre of the
# crankshaft at bottom dead point. All sizes are made up. tests/unit/machine/cad.cpp counts every contact that the drawing holds.
pload MODELING XDE OCAF

proc block {name x0 x1 y0 y1 z0 z1} { uplevel #0 [list box $name $x0 $y0 $z0 [expr $x1-$x0] [expr $y1-$y0] [expr $z1-$z0]] }
# A full cylinder along z, y or x.
proc rod {name axis a b radius from to} {
    set length [expr {$to - $from}]
    uplevel #0 [list pcylinder $name $radius $length]
    if {$axis eq "z"} { uplevel #0 [list ttranslate $name $a $b $from] }
    if {$axis eq "y"} { uplevel #0 "trotate $name 0 0 0 1 0 0 -90; ttranslate $name $a $from $b" }
    if {$axis eq "x"} { uplevel #0 "trotate $name 0 0 0 0 1 0 90; ttranslate $name $from $a $b" }
}
proc minus {name args} { foreach tool $args { uplevel #0 "bcut $name $name $tool" } }
proc plus {name args} { foreach tool $args { uplevel #0 "bfuse $name $name $tool" } }

# The frame: two side plates with a throat, a table, a back wall and the bearing walls are one casting.
block frame -300 300 -1100 -950 -350 350
block back -300 300 -950 300 -350 -250
block head -300 300 -250 300 -250 350
block hollow -220 220 -250 240 -190 290
block throat_rib -25 25 -950 -250 -250 -200
plus frame back head throat_rib
minus frame hollow
# Bores of the bearing walls, M16 holes in the table, an oil hole, lifting holes.
rod bore z 0 0 82.5 -400 400
minus frame bore
foreach {x z} {-250 -300 250 -300 -250 300 250 300} { rod hole y $x $z 7 -1100 -950; minus frame hole }
foreach {x y} {-260 270 260 270} { rod hole z $x $y 6 250 350; minus frame hole }
rod hole y 0 320 4 60 300
minus frame hole
explode frame E
# Roundings of the outer vertical edges of the head and of the table.
set rounded {}
foreach edge [directory frame_*] {
    regexp {} $edge
    set box [bounding $edge]
    lassign $box x0 y0 z0 x1 y1 z1
    if {abs($x1-$x0) < 1 && abs($z1-$z0) < 1 && abs($y1-$y0) > 100 && abs(abs($x0)-300) < 1 && abs(abs($z0)-350) < 1} {
        lappend rounded 5 $edge
    }
}
if {[llength $rounded] > 0} { eval blend frame frame $rounded }

# Two roller bearings that were bought in: their rings only, 100 x 165 x 52 mm, as the maker's drawing has them.
foreach {name middle} {bearing_front 320 bearing_back -220} {
    foreach {ring outer inner} {outer_ring 82.5 72 inner_ring 60 50} {
        rod ${name}_$ring z 0 0 $outer [expr {$middle - 26}] [expr {$middle + 26}]
        rod hollow z 0 0 $inner -400 400
        minus ${name}_$ring hollow
    }
}
# The eccentric shaft: journals of 100 mm, an eccentric of 180 mm thrown 30 mm down.
rod crankshaft z 0 0 50 -420 380
rod eccentric z 0 -30 90 -60 60
rod web_front z 0 -20 75 60 284
rod web_back z 0 -20 75 -184 -60
plus crankshaft eccentric web_front web_back
# The flywheel at the back end.
rod flywheel z 0 0 250 -415 -355
rod inner z 0 0 50 -500 500
minus flywheel inner
foreach {x y} {150 0 -150 0 0 150 0 -150} { rod hole z $x $y 40 -500 500; minus flywheel hole }

# The connecting rod on the eccentric, with an eye for the wrist pin.
rod connecting_rod z 0 -30 130 -50 50
rod eye z 0 -400 65 -50 50
block shank -45 45 -390 -150 -40 40
plus connecting_rod eye shank
rod inner z 0 -30 90 -100 100
rod small z 0 -400 35 -100 100
minus connecting_rod inner small
rod hole y -80 0 5 -75 90
minus connecting_rod hole

# The slide with its wrist pin pressed in, guided on both sides by gibs.
block slide -150 150 -780 -330 -120 120
block pocket -70 70 -480 -330 -52 52
minus slide pocket
rod seat z 0 -400 35 -120 120
minus slide seat
foreach {x z} {-100 -80 100 -80 -100 80 100 80} { rod hole y $x $z 6 -780 -740; minus slide hole }
rod wrist_pin z 0 -400 35 -120 120

# Gibs, bolted to brackets that stand at the back wall.
foreach {name x0 x1} {gib_left -220 -150 gib_right 150 220} { block $name $x0 $x1 -760 -420 -200 150 }
foreach {name x0 x1} {bracket_left -300 -220 bracket_right 220 300} { block $name $x0 $x1 -770 -410 -250 150 }
# A plate on the table.
block bolster -250 250 -950 -890 -150 250
block motor_foot -100 100 300 330 -250 0
rod motor z 0 420 90 -230 -30
block motor_base -60 60 330 400 -200 -50
plus motor motor_base

set solids {frame bearing_front_outer_ring bearing_front_inner_ring bearing_back_outer_ring bearing_back_inner_ring crankshaft flywheel connecting_rod slide wrist_pin gib_left gib_right bracket_left
            bracket_right bolster motor_foot motor}
NewDocument Press BinXCAF
foreach name $solids {
    set label [XAddShape Press $name 0]
    SetName Press $label $name
}
WriteStep Press press.step
foreach name $solids { puts "$name [lindex [regexp -inline {Mass :\s+([0-9.e+]+)} [vprops $name]] 1]" }
exit
