; 64 slots, 32000 us of light a frame
; 183 words stored in 37 kernels; 183 executed a frame in 37 launches, 203.5 us
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
| or_sources = "any"                         # most sources of an OR or NOR word: "any" or a number (not public)
| where_sources = "any"                      # most sources of a WHERE word: "any" or a number (not public)
|
| [store]
| words = 1024                               # largest number of ICWs in all stored kernels
| tables_count = true                        # do constant kernel tables count against the store? (not public)
|
| [time]
| analog_word_us = 2.0                       # one analog word (not public)
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
| directed_sources = 2                       # most analog sources of a word that writes or reads a neighbour's NEWS (not public)
| directed_halving = false                   # may a bus2 word read a neighbour's NEWS? (not public)
| news_read_keeps = true                     # does NEWS keep its value when neighbours read it? (not public)
.note class "d"
.note codes "fixed"
.note level "0"
.note lowering "edges"

.source
| # One bump, beginning and ending where each pixel says (class d): moments as in class c, and
| # exposure times as in class b, for scenes that are both fast and of high contrast.
| nsl 1
|
| frame 64 slots of 500us
|
| code start : 0..N - 1
| code stop : 1..N
| require start < stop
| open when start <= n < stop
|
| pixels start = (x % 8 + 4 * (y % 4)) % 32
| pixels stop = N / 2 + 1 + (x % 8) * (y % 4) % 32

.wait 500us x64

.kernel k0                               ; 8 words, 17 us; launched at 0
    all
    bus NEWS
    bus A, NEWS
    rpix
    rpix
    nop
    bus NEWS, PIX
    bus B, NEWS

.kernel k1                               ; 4 words, 5.2 us; launched at 1
    NOR R0, R1, R3, R4, R6, R9
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k2                               ; 4 words, 5.2 us; launched at 2
    NOR R0, R4, R6, R9, R12
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k3                               ; 4 words, 5.2 us; launched at 3
    NOR R0, R3, R5, R6, R9, R12
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k4                               ; 4 words, 5.2 us; launched at 4
    NOR R0, R1, R3, R5, R6, R9
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k5                               ; 4 words, 5.2 us; launched at 5
    NOR R0, R2, R5, R6, R9
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k6                               ; 4 words, 5.2 us; launched at 6
    NOR R0, R2, R5, R7, R9
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k7                               ; 4 words, 5.2 us; launched at 7
    NOR R0, R3, R5, R7, R9
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k8                               ; 4 words, 5.2 us; launched at 8
    NOR R0, R3, R4, R7, R9
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k9                               ; 4 words, 5.2 us; launched at 9
    NOR R0, R2, R4, R7, R9
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k10                              ; 4 words, 5.2 us; launched at 10
    NOR R0, R2, R4, R7, R8
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k11                              ; 4 words, 5.2 us; launched at 11
    NOR R0, R3, R4, R7, R8
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k12                              ; 4 words, 5.2 us; launched at 12
    NOR R0, R3, R5, R7, R8
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k13                              ; 4 words, 5.2 us; launched at 13
    NOR R0, R2, R5, R7, R8
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k14                              ; 4 words, 5.2 us; launched at 14
    NOR R0, R2, R5, R6, R8
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k15                              ; 4 words, 5.2 us; launched at 15
    NOR R0, R3, R5, R6, R8
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k16                              ; 4 words, 5.2 us; launched at 16
    NOR R0, R3, R4, R6, R8, R12
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k17                              ; 4 words, 5.2 us; launched at 17
    NOR R0, R1, R3, R4, R6, R8
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k18                              ; 4 words, 5.2 us; launched at 18
    NOR R0, R1, R2, R4, R6, R8
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k19                              ; 4 words, 5.2 us; launched at 19
    NOR R0, R2, R4, R6, R12
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k20                              ; 14 words, 6.2 us; launched at 33
    NOR R0, R1, R3, R5, R7, R8
    NOR R10, R1, R3, R4, R9
    NOR R11, R3, R5, R9, R12
    OR R0, R0, R10, R11
    NOR R10, R1, R2, R5, R7, R9
    NOR R11, R6, R9, R12
    OR R0, R0, R10, R11
    NOR R10, R3, R6, R9
    NOR R11, R4, R6, R9
    WHERE R0, R10, R11
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k21                              ; 4 words, 5.2 us; launched at 34
    NOR R0, R1, R2, R5, R6, R9
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k22                              ; 4 words, 5.2 us; launched at 35
    NOR R0, R2, R7, R9, R12
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k23                              ; 5 words, 5.3 us; launched at 36
    NOR R0, R2, R5, R7, R8, R12
    NOR R10, R1, R3, R5, R7, R9
    WHERE R0, R10
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k24                              ; 5 words, 5.3 us; launched at 37
    NOR R0, R1, R2, R4, R7, R8
    NOR R10, R3, R4, R7, R9, R12
    WHERE R0, R10
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k25                              ; 4 words, 5.2 us; launched at 38
    NOR R0, R1, R2, R4, R7, R9
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k26                              ; 5 words, 5.3 us; launched at 39
    NOR R0, R1, R2, R5, R6, R8
    NOR R10, R4, R7, R8, R12
    WHERE R0, R10
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k27                              ; 4 words, 5.2 us; launched at 40
    NOR R0, R1, R3, R4, R7, R8
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k28                              ; 4 words, 5.2 us; launched at 41
    NOR R0, R3, R5, R7, R8, R12
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k29                              ; 4 words, 5.2 us; launched at 42
    NOR R0, R3, R5, R6, R8, R12
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k30                              ; 4 words, 5.2 us; launched at 43
    NOR R0, R1, R2, R5, R7, R8
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k31                              ; 5 words, 5.3 us; launched at 45
    NOR R0, R3, R4, R6, R8, R12
    NOR R10, R2, R5, R6, R8, R12
    WHERE R0, R10
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k32                              ; 4 words, 5.2 us; launched at 47
    NOR R0, R1, R3, R5, R6, R8
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k33                              ; 4 words, 5.2 us; launched at 48
    NOR R0, R1, R3, R4, R6, R8
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k34                              ; 4 words, 5.2 us; launched at 51
    NOR R0, R1, R2, R4, R6, R8
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k35                              ; 4 words, 5.2 us; launched at 54
    NOR R0, R2, R4, R6, R12
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k36                              ; 21 words, 3.1 us; launched at 64
    SET R0
    REFRESH R12
    REFRESH R1
    REFRESH R2
    REFRESH R3
    REFRESH R4
    REFRESH R5
    REFRESH R6
    REFRESH R7
    REFRESH R8
    REFRESH R9

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
.slot 17 k17
.slot 18 k18
.slot 19 k19
.slot 33 k20
.slot 34 k21
.slot 35 k22
.slot 36 k23
.slot 37 k24
.slot 38 k25
.slot 39 k26
.slot 40 k27
.slot 41 k28
.slot 42 k29
.slot 43 k30
.slot 45 k31
.slot 47 k32
.slot 48 k33
.slot 51 k34
.slot 54 k35
.slot 64 k36

.bucket frame
.readout A frame 1

.load R12 R1 R2 R3 R4 R5 R6 R7 R8 R9
.fields start stop
; a line a shutter: R0..R12 at the start of a frame, then the open slots of each bucket
.shutter 0101010101000 19..53            ; 0
.shutter 0001010101001 18..50            ; 1
.shutter 0010010101001 17..47            ; 2
.shutter 0110010101000 16..44            ; 3
.shutter 0110100101000 15..41            ; 4
.shutter 0010100101001 15..46            ; 5
.shutter 0001100101001 14..38            ; 6
.shutter 0101100101000 14..44            ; 7
.shutter 0101101001000 13..35            ; 8
.shutter 0001101001001 13..42            ; 9
.shutter 0010101001001 12..32            ; 10
.shutter 0110101001000 12..40            ; 11
.shutter 0110011001000 11..38            ; 12
.shutter 0010011001001 11..39            ; 13
.shutter 0001011001001 10..36            ; 14
.shutter 0101011001000 10..38            ; 15
.shutter 0101011010000 9..34             ; 16
.shutter 0001011010001 9..37             ; 17
.shutter 0010011010001 8..32             ; 18
.shutter 0110011010000 8..36             ; 19
.shutter 0110101010000 7..32             ; 20
.shutter 0010101010001 7..35             ; 21
.shutter 0001101010001 6..32             ; 22
.shutter 0101101010000 6..34             ; 23
.shutter 0101100110000 5..32             ; 24
.shutter 0001100110001 5..33             ; 25
.shutter 0010100110001 4..32             ; 26
.shutter 0110100110000 3..32             ; 27
.shutter 0110010110000 2..32             ; 28
.shutter 0010010110001 1..32             ; 29
.shutter 0001010110001 0..32             ; 30
; a line a code: its shutter, then its fields
.code 30 0 33
.code 29 1 33
.code 28 2 33
.code 27 3 33
.code 26 4 33
.code 24 5 33
.code 25 5 34
.code 22 6 33
.code 23 6 35
.code 20 7 33
.code 21 7 36
.code 18 8 33
.code 19 8 37
.code 16 9 35
.code 17 9 38
.code 14 10 37
.code 15 10 39
.code 12 11 39
.code 13 11 40
.code 10 12 33
.code 11 12 41
.code 8 13 36
.code 9 13 43
.code 6 14 39
.code 7 14 45
.code 4 15 42
.code 5 15 47
.code 3 16 45
.code 2 17 48
.code 1 18 51
.code 0 19 54

; the code of every pixel
.pixels tile 4 8
| 0 1 2 3 4 5 7 9
| 4 6 8 10 12 14 16 18
| 11 13 15 17 20 22 24 26
| 19 21 23 25 27 28 29 30
