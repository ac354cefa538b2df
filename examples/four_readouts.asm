; 16 slots, 2000 us of light a frame
; 83 words stored in 17 kernels; 83 executed a frame in 17 launches, 31.3 us
.target
| # A target of nscc: what the compiler, the checker and the emulator know of a chip.
| # Keys marked (not public) are this project's defaults; they may be left out.
| name = "scamp5"
| kind = "scamp"
| description = "SCAMP-5: global PIX reset, non-destructive read"
|
| [array]                                    # the pixels
| rows = 256                                 # pixels from top to bottom
| cols = 256                                 # pixels from left to right
|
| [registers]                                # of one pixel
| analog = ["A", "B", "C", "D", "E", "F", "NEWS"] # analog registers of one pixel
| analog_scratch = "NEWS"                    # register that every analog sequence overwrites
| # one-bit registers of one pixel
| digital = ["R0", "R1", "R2", "R3", "R4", "R5", "R6", "R7", "R8", "R9", "R10", "R11", "R12"]
| mask = "R0"                                # a word changes `masked` only in pixels where this register is 1
| masked = "R12"                             # the register that `mask` guards; both are "none" on a chip without this
|
| [behaviour]                                # these values are not public: each key has a default
| reset_honours_flag = "no"                  # does rpix reset only where FLAG is 1? "no", "yes" or "unknown" (not public)
| where_reads_flag = false                   # may WHERE read FLAG, which it also writes? (not public)
| where_obeys_flag = false                   # does the analog `where` itself act only where FLAG is 1? (not public)
| or_sources = 3                             # most sources of an OR or NOR word: "any" or a number (not public)
| where_sources = "any"                      # most sources of a WHERE word: "any" or a number (not public)
|
| [store]
| words = 10240                              # largest number of ICWs in all stored kernels
| tables_count = true                        # do constant kernel tables count against the store? (not public)
|
| [time]
| analog_word_us = 0.2                       # one analog word (not public)
| digital_word_us = 0.1                      # one digital word (not public)
| launch_us = 1.0                            # overhead of one kernel launch (not public)
| wait_us = 1.0                              # the frame loop's own time at a boundary (not public)
| readout_us = 16700.0                       # reading one analog register, or all taps, of the whole array out (not public)
| digital_retention_us = 1500000.0           # time for which a digital register keeps an unwritten bit
|
| [range]
| full_well_e = 30000.0                      # electrons that PIX, or a tap, can hold (not public)
| register_min_e = -30000.0                  # least value of an analog register, below 0 (not public)
| register_max_e = 30000.0                   # largest value of an analog register, above 0 (not public)
| adc_bits = 8                               # bits of the readout
| adc_offset_lsb = 0.0                       # offset added to the converter code of an exposure of 0 (not public)
| readout = "spread"                         # codes of 0 .. full_well_e: spread, all of them (2 x exposure - full well is converted); full, the upper half, for the converter is symmetric around 0; half, 0 to the middle (not public)
|
| [in]                                       # the global value IN that every pixel can compare with; set between kernels
| in_low = -127                              # least value of IN, in steps (not public)
| in_high = 126                              # largest value of IN, in steps (not public)
| in_step_e = "auto"                         # electrons a step of IN; "auto": register_max_e / 127 (not public)
| in_settle_us = 5.0                         # time from setting IN to the first word that reads it (not public)
|
| [neighbours]                               # how words reach the pixels to the north, east, south and west
| sees_neighbours = true                     # do words reach the NEWS, and the digital registers, of neighbours? (not public)
| directed_sources = 3                       # most analog sources of a word that writes or reads a neighbour's NEWS (not public)
| directed_halving = false                   # may a bus2 word read a neighbour's NEWS? (not public)
| news_read_keeps = true                     # does NEWS keep its value when neighbours read it? (not public)
.note class "general"
.note codes "fixed"
.note level "0"
.note lowering "edges"

.source
| # A clip in four readouts of one exposure. One is always open, as in an ordinary camera; the other
| # three are quarters of the frame, one after the other, from a phase of the pixel's own. The light
| # of the first readout that is in none of them came in the fourth quarter.
| # `nscc demo CLIP --readouts 4` exposes with it; `nscc reconstruct any` joins the readouts.
| nsl 1
|
| frame 16 slots of 125us
| code phase : 0..3
|
| bucket long open when true
| bucket first open when phase <= n < phase + 4
| bucket second open when phase + 4 <= n < phase + 8
| bucket third open when phase + 8 <= n < phase + 12
|
| pixels phase = tile [[0, 2],
|                      [3, 1]]

.wait 125us x16

.kernel k0                               ; 11 words, 3.2 us; launched at 0
    all
    bus NEWS
    bus A, NEWS
    bus B, NEWS
    bus C, NEWS
    bus D, NEWS
    rpix
    rpix
    nop
    bus NEWS, PIX
    bus E, NEWS

.kernel k1                               ; 3 words, 1.5 us; launched at 1
    WHERE R1
    bus NEWS, B, E
    bus B, NEWS, PIX

.kernel k2                               ; 3 words, 1.5 us; launched at 2
    WHERE R2
    bus NEWS, B, E
    bus B, NEWS, PIX

.kernel k3                               ; 3 words, 1.5 us; launched at 3
    WHERE R3
    bus NEWS, B, E
    bus B, NEWS, PIX

.kernel k4                               ; 5 words, 1.9 us; launched at 4
    WHERE R4
    bus NEWS, B, PIX
    bus B, NEWS, E
    bus NEWS, C, E
    bus C, NEWS, PIX

.kernel k5                               ; 5 words, 1.9 us; launched at 5
    WHERE R1
    bus NEWS, B, PIX
    bus B, NEWS, E
    bus NEWS, C, E
    bus C, NEWS, PIX

.kernel k6                               ; 5 words, 1.9 us; launched at 6
    WHERE R2
    bus NEWS, B, PIX
    bus B, NEWS, E
    bus NEWS, C, E
    bus C, NEWS, PIX

.kernel k7                               ; 5 words, 1.9 us; launched at 7
    WHERE R3
    bus NEWS, B, PIX
    bus B, NEWS, E
    bus NEWS, C, E
    bus C, NEWS, PIX

.kernel k8                               ; 5 words, 1.9 us; launched at 8
    WHERE R4
    bus NEWS, C, PIX
    bus C, NEWS, E
    bus NEWS, D, E
    bus D, NEWS, PIX

.kernel k9                               ; 5 words, 1.9 us; launched at 9
    WHERE R1
    bus NEWS, C, PIX
    bus C, NEWS, E
    bus NEWS, D, E
    bus D, NEWS, PIX

.kernel k10                              ; 5 words, 1.9 us; launched at 10
    WHERE R2
    bus NEWS, C, PIX
    bus C, NEWS, E
    bus NEWS, D, E
    bus D, NEWS, PIX

.kernel k11                              ; 5 words, 1.9 us; launched at 11
    WHERE R3
    bus NEWS, C, PIX
    bus C, NEWS, E
    bus NEWS, D, E
    bus D, NEWS, PIX

.kernel k12                              ; 3 words, 1.5 us; launched at 12
    WHERE R4
    bus NEWS, D, PIX
    bus D, NEWS, E

.kernel k13                              ; 3 words, 1.5 us; launched at 13
    WHERE R1
    bus NEWS, D, PIX
    bus D, NEWS, E

.kernel k14                              ; 3 words, 1.5 us; launched at 14
    WHERE R2
    bus NEWS, D, PIX
    bus D, NEWS, E

.kernel k15                              ; 3 words, 1.5 us; launched at 15
    WHERE R3
    bus NEWS, D, PIX
    bus D, NEWS, E

.kernel k16                              ; 11 words, 2.4 us; launched at 16
    all
    bus NEWS, A, PIX
    bus A, NEWS, E
    REFRESH R1
    REFRESH R2
    REFRESH R3
    REFRESH R4

.slot 0 k0
.slot 1 k1
.slot 2 k2
.slot 3 k3
.slot 4 k4
.slot 5 k5
.slot 6 k6
.slot 7 k7
.slot 8 k8
.slot 9 k9
.slot 10 k10
.slot 11 k11
.slot 12 k12
.slot 13 k13
.slot 14 k14
.slot 15 k15
.slot 16 k16

.bucket long first second third
.readout A long 1
.readout B first 1
.readout C second 1
.readout D third 1

.load R1 R2 R3 R4
.fields phase
; a line a shutter: R0..R12 at the start of a frame, then the open slots of each bucket
.shutter 0001000000000 0..15 3..6 7..10 11..14 ; 0
.shutter 0010000000000 0..15 2..5 6..9 10..13 ; 1
.shutter 0100000000000 0..15 1..4 5..8 9..12 ; 2
.shutter 0000100000000 0..15 0..3 4..7 8..11 ; 3
; a line a code: its shutter, then its fields
.code 3 0
.code 2 1
.code 1 2
.code 0 3

; the code of every pixel
.pixels tile 2 2
| 0 2
| 3 1
