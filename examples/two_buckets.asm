; 64 slots, 16000 us of light a frame
; 26 words stored in 4 kernels; 26 executed a frame in 4 launches, 8.6 us
.target
| # A target of nscc: what the compiler, the checker and the emulator know of a chip.
| # Keys marked (not public) are this project's defaults; they may be left out.
| name = "scamp5"
| kind = "scamp"
| description = "SCAMP-5: global PIX reset, non-destructive read"
|
| [array]                                    # the pixels
| rows = 1                                   # pixels from top to bottom
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
| directed_sources = 2                       # most analog sources of a word that writes or reads a neighbour's NEWS (not public)
| directed_halving = false                   # may a bus2 word read a neighbour's NEWS? (not public)
| news_read_keeps = true                     # does NEWS keep its value when neighbours read it? (not public)
.note class "general"
.note codes "fixed"
.note level "0"
.note lowering "edges"

.source
| # Two frames from one exposure, each in an analog register of its own: what arrives before a
| # pixel's split, and what arrives after it. Together they are the full exposure.
| nsl 1
|
| frame 64 slots of 250us
|
| code split : 1..N - 1
| bucket early open when n < split
| bucket late open when n >= split
|
| pixels split = 16 if x % 2 == 0 else 48

.wait 250us x64

.kernel k0                               ; 9 words, 2.8 us; launched at 0
    all
    bus NEWS
    bus A, NEWS
    bus B, NEWS
    rpix
    rpix
    nop
    bus NEWS, PIX
    bus C, NEWS

.kernel k1                               ; 5 words, 1.9 us; launched at 16
    WHERE R1
    bus NEWS, A, PIX
    bus A, C, NEWS
    bus NEWS, B, C
    bus B, NEWS, PIX

.kernel k2                               ; 5 words, 1.9 us; launched at 48
    WHERE R2
    bus NEWS, A, PIX
    bus A, C, NEWS
    bus NEWS, B, C
    bus B, NEWS, PIX

.kernel k3                               ; 7 words, 2 us; launched at 64
    all
    bus NEWS, B, PIX
    bus B, C, NEWS
    REFRESH R1
    REFRESH R2

.slot 0 k0
.slot 16 k1
.slot 48 k2
.slot 64 k3

.bucket early late
.readout A early 1
.readout B late 1

.load R1 R2
.fields split
; a line a shutter: R0..R12 at the start of a frame, then the open slots of each bucket
.shutter 0100000000000 0..15 16..63      ; 0
.shutter 0010000000000 0..47 48..63      ; 1
; a line a code: its shutter, then its fields
.code 0 16
.code 1 48

; the code of every pixel
.pixels tile 1 2
| 0 1
