// What programs for the devkit have in common: `nscc.emit.cpp.text.part` takes a part, from the
// line behind its `//:` on, and puts values in place of names between `@`.

//: run
// Runs a constant table, be scamp5_kernel(table, n) a function that runs it or an object that runs
// when it is called.
struct Run {};
template <class Kernel>
auto operator,(Kernel &&kernel, Run) -> decltype(kernel()) {
    return kernel();
}

//: clock
#ifdef __LPC43XX__
#define SLOW_CLOCK allow_highspeed(false);      // analog words do not keep up with the fast one
#else
#define SLOW_CLOCK
#endif

//: await
#ifdef __LPC43XX__
const uint32_t late_us = 8;         // a launch that comes later: the clock may tick every 7 us
uint32_t late;                      // so many did in this frame

// Waits until so many microseconds have passed since the frame's first word.
void await(const vs_stopwatch &clock, uint32_t us) {
#ifdef REST_US                      // for instance -DREST_US=1000: longer waits save power
    if (int32_t(us - clock.get_usec()) > REST_US) {
        vs_vision_chip_rest();
    }
#endif
    const int32_t left = int32_t(us - clock.get_usec());
    if (left > 32) {
        vs_wait(uint32_t(left - 16));
    }
    while (int32_t(clock.get_usec() - us) < 0) {
    }
    late += int32_t(clock.get_usec() - us) > int32_t(late_us);
}
#else
// In the devkit's simulator light falls when it is told to: the share of the frame that has passed
// since the moment before. Shares are counted from the frame's beginning, so that none gets lost.
double passed_us;
uint32_t last_us;
uint16_t fallen;

void await(const vs_stopwatch &, uint32_t us) {
    passed_us += uint32_t(us - last_us);
    last_us = us;
    const double share = (passed_us - @begin@) / (@end@ - @begin@);
    const uint16_t until = uint16_t(65535 * (share < 1 ? share : 1) + 0.5);
    vs_sim::pix_integrate(uint16_t(until - fallen), 65535);
    fallen = until;
}
#endif

//: step
struct Step {
    uint32_t at_us;                 // this long after the frame's first word
    uint32_t every_us;              // and again and again after so long,
    uint16_t kernel;                // this one of `kernels` runs,
    uint16_t times;                 // so many times in all
};

//: step_in
struct Step {
    uint32_t at_us;                 // this long after the frame's first word
    uint32_t every_us;              // and again and again after so long,
    uint16_t kernel;                // this one of `kernels` runs,
    uint16_t times;                 // so many times in all
    int16_t in;                     // with IN at so many steps; -32768: as it is
};

//: step_parts
struct Step {
    uint32_t at_us, at_part;        // this long after the frame's first word (parts: 2^-32 us)
    uint32_t every_us, every_part;  // and again and again after so long,
    uint16_t kernel;                // this one of `kernels` runs,
    uint16_t times;                 // so many times in all
};

//: step_parts_in
struct Step {
    uint32_t at_us, at_part;        // this long after the frame's first word (parts: 2^-32 us)
    uint32_t every_us, every_part;  // and again and again after so long,
    uint16_t kernel;                // this one of `kernels` runs,
    uint16_t times;                 // so many times in all
    int16_t in;                     // with IN at so many steps; -32768: as it is
};

//: begin_in
    int16_t in = -32768;

//: moment
        uint32_t us = step.at_us;
        for (uint16_t i = 0; i < step.times; ++i) {

//: moment_parts
        uint32_t at_us = step.at_us, part = step.at_part;
        for (uint16_t i = 0; i < step.times; ++i) {
            const uint32_t us = at_us + (part > 0);

//: settle
            if (step.in != -32768 && step.in != in) {
                scamp5_load_in(int8_t(step.in));
                in = step.in;
#ifdef __LPC43XX__
                vs_wait(@settle@);
#endif
            }

//: after
            us += step.every_us;

//: after_parts
            part += step.every_part;
            at_us += step.every_us + (part < step.every_part);

//: limited
bool is_first_frame = true;

// How often a row of the schedule runs, at most `most` times.
uint16_t limited(int times, int most) {
    return uint16_t(times < 0 ? 0 : times > most ? most : times);
}

//: expose
void expose() {
    vs_stopwatch clock;
    clock.reset();
    uint32_t before = 0;
#ifdef __LPC43XX__
    late = 0;
#else
    passed_us = 0;
    last_us = 0;
    fallen = 0;
#endif
@begin@
    for (const Step &step : schedule) {
@moment@
            // What a boundary launches beside its first kernel follows at once.
            if (us != before) {
                await(clock, us);
                before = us;
            }
@settle@
            kernels[step.kernel]();
@after@
        }
    }
}

//: fading
// Digital memory fades when it is not written for a while: all codes are written back after each
// plane, and again and again during what takes long.

//: match
// All pixels whose address is (row, col) but for the bits set in the masks.
struct Match {
    uint8_t row, col, row_mask, col_mask;
};

//: among
template <int count>
bool among(const Match (&matches)[count], int row, int col) {
    for (const Match &match : matches) {
        if (((row ^ match.row) & ~match.row_mask) == 0 &&
            ((col ^ match.col) & ~match.col_mask) == 0) {
            return true;
        }
    }
    return false;
}

//: images
// Draws an image onto a cleared plane. Column 0 of the image is its left one, column 0 of the array
// the right one.
template <class Plane>
void draw(const vs_dotmat &image, const Plane &plane) {
    const uint8_t *bits = static_cast<const uint8_t *>(image.get_buffer());
    scamp5_draw_begin(plane);
    for (int row = 0; row < rows; ++row) {
        for (int x = 0; x < cols; ++x) {
            if (bits[(row * @width@ + x) / 8] >> x % 8 & 1) {
                scamp5_draw_pixel(row, cols - 1 - x);
            }
        }
        if (row % 16 == 15) {
            refresh_codes();
        }
    }
    scamp5_draw_end();
}

// Asks the host for an image until it is there, with the right size: a request that is not answered
// in time, or was not taken, is made again.
template <class Plane>
void load_image(const char *file, const Plane &plane) {
    bool drawn = false;
    while (!drawn) {
        bool answered = false;
        vs_gui_request_image(file, 1, [&](const vs_dotmat &image, int status) {
            answered = true;
            if (status >= 0 && image.get_width() == @width@ &&
                image.get_height() == rows) {
                draw(image, plane);
                drawn = true;
            }
        });
        for (int turn = 0; turn < 20 && !answered; ++turn) {
            vs_frame_loop_control();
            refresh_codes();
        }
    }
}

//: drawn
    scamp5_draw_begin(@register@);
    for (int row = 0; row < rows; ++row) {
        for (int col = 0; col < cols; ++col) {
            if (@inverted@among(@codes@, row, col)) {
                scamp5_draw_pixel(row, col);
            }
        }
        if (row % 16 == 15) {
            refresh_codes();
        }
    }
    scamp5_draw_end();

//: gathered
    for (const Match &match : @codes@) {
        scamp5_load_pattern(@scratch@, match.row, match.col, match.row_mask,
                            match.col_mask);
@add@
    }

//: record
#ifdef __LPC43XX__
    // A kernel is recorded when it first runs, which takes time: here, where none is lost.
    for (void (*kernel)() : kernels) {
        kernel();
    }
#endif

//: awaiting
    // While images are awaited, codes are refreshed at this rate.
    vs_configure_frame_trigger(VS_FRAME_TRIGGER_CONST_LOOP, @rate@);

//: spread
        // A converter that is symmetric around 0 has all of its codes for 2 x exposure - full well.
        scamp5_load_in(@level@);
#ifdef __LPC43XX__
        vs_wait(@settle@);
#endif

//: margins
uint32_t frame;                     // so many frames came before

// Writes the numbers of columns on the left and right and of rows at the top and bottom that depend
// on values beyond the array and are left out of a report: the smallest in the rows `cases` of
// `margins`. A row is for the number of this frame, where the last row is for all later frames, or
// for the values of the sliders.
template <uint32_t rows, uint32_t count>
void choose(const uint16_t (&margins)[rows][4], const uint32_t (&cases)[count], int (&margin)[4]) {
    for (int side = 0; side < 4; ++side) {
        margin[side] = 65535;
        for (uint32_t row : cases) {
            const int width = margins[row < rows ? row : rows - 1][side];
            margin[side] = width < margin[side] ? width : margin[side];
        }
    }
}

//: report
// Sends the bits of a plane to the host as text: the first `most` coordinates, then the number of
// bits and the box around them. (In the simulator, the displays show the planes.)
template <class Plane, uint32_t rows, uint32_t count_of_cases>
void report(const char *name, const Plane &plane, const uint16_t (&margins)[rows][4],
            const uint32_t (&cases)[count_of_cases], int most) {
    int margin[4];
    choose(margins, cases, margin);
    int count = 0, box[] = {@cols@, @rows@, -1, -1};
    for (int y = margin[2]; y < @rows@ - margin[3]; ++y) {
        uint8_t bits[32];
        scamp5_scan_dreg(plane, bits, uint8_t(y), uint8_t(y));
        for (int x = margin[0]; x < @cols@ - margin[1]; ++x) {
            const int place = @cols@ - 1 - x;       // the first bit is the rightmost pixel
            if (!(bits[place / 8] >> place % 8 & 1)) {
                continue;
            }
            if (count++ < most) {
                vs_post_text("%s: %d %d\n", name, x, y);
            }
            box[0] = x < box[0] ? x : box[0];
            box[1] = y < box[1] ? y : box[1];
            box[2] = x > box[2] ? x : box[2];
            box[3] = y;
        }
    }
    vs_post_text("%s: %d in %d %d to %d %d\n", name, count, box[0], box[1], box[2], box[3]);
}

//: sum
// Sends the sum of an image to the host as text, in steps of the converter, of which `zero` stand
// for 0. (In the simulator, the displays show the image.)
template <class Image, uint32_t rows, uint32_t count_of_cases>
void sum(const char *name, const Image &image, const uint16_t (&margins)[rows][4],
         const uint32_t (&cases)[count_of_cases], double zero) {
    int margin[4];
    choose(margins, cases, margin);
    double total = 0;
    for (int x = margin[0]; x < @cols@ - margin[1]; ++x) {
        uint8_t codes[@rows@];
        const uint8_t col = uint8_t(@cols@ - 1 - x);
        scamp5_scan_areg(image, codes, 0, col, @rows@ - 1, col, 1, 1);
        for (int y = margin[2]; y < @rows@ - margin[3]; ++y) {
            total += codes[y] - zero;
        }
    }
    vs_post_text("%s: %d\n", name, int(total < 0 ? total - 0.5 : total + 0.5));
}

//: input
        if (wanted_@number@ != loaded_@number@) {
            // The host changed the slider: its image is loaded again, while codes are refreshed.
            loaded_@number@ = wanted_@number@;
            vs_configure_frame_trigger(VS_FRAME_TRIGGER_CONST_LOOP, @rate@);
            load_@register@();
            refresh_codes();
        }

//: frames
        // No frame waits for the next: codes fade meanwhile.
        vs_disable_frame_trigger();
        vs_frame_loop_control();
        expose();
#ifdef __LPC43XX__
        if (late) {
            vs_post_text("%u launches came late\n", unsigned(late));
        }
#endif
        // Pixels that FLAG leaves out would be left out of readout.
@prepare@
