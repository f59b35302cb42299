/* Calls every function of an exported library, and prints what it gives, for `.ci/c` to compare with Rust.
 *
 * Compiled once for each arm: ARM and UPPER are the library's name, HEADER its header, NUMBER its number type. WITH calls the functions that
 * take parameters, NOMINAL says that there are nominal ones, NO_INVERSE leaves the inverse out.
 *
 * Standard input holds one case on a line: joint values, target, joints that are given, all as the bits of doubles. `check time` prints times.
 */
#define _POSIX_C_SOURCE 199309L
#include HEADER
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define GLUE(a, b) a##_##b
#define OF(a, b) GLUE(a, b)
#define TYPE(name) OF(ARM, name)
#define CONSTANT(name) OF(UPPER, name)
#define DOF CONSTANT(DOF)
#define NULL_POINTER CONSTANT(NULL_POINTER)

#ifdef WITH
#define CALL(name) GLUE2(ARM, name)
#define GLUE2(a, b) GLUE3(a, b)
#define GLUE3(a, b) a##_##b##_with
#define SELF &params,
static TYPE(params) params;
#else
#define CALL(name) OF(ARM, name)
#define SELF
#endif

#ifdef NO_INVERSE
#define TARGET 1
#define GIVEN 0
#else
#define TARGET CONSTANT(TARGET)
#define GIVEN CONSTANT(GIVEN)
#define MOST CONSTANT(MAX_SOLUTIONS)
#if GIVEN == 0
#define PASS(given)
#elif GIVEN == 1
#define PASS(given) (given)[0],
#else
#define PASS(given) (given),
#endif
#if GIVEN == 0
#define PASS_ALL(given)
#else
#define PASS_ALL(given) (given),
#endif
#endif

enum { CASES = 4096 };
static NUMBER q[CASES * DOF], targets[CASES * TARGET], given[CASES * (GIVEN + 1)];
static size_t count;

static void require(int holds, const char *what) {
    if (!holds) {
        fprintf(stderr, "wrong: %s\n", what);
        exit(1);
    }
}

static void numbers(const char *name, const NUMBER *list, size_t length) {
    size_t i;
    printf("%s", name);
    for (i = 0; i < length; i++) {
        double wide = list[i];
        uint64_t bits;
        memcpy(&bits, &wide, sizeof bits);
        if (wide != wide) {
            printf(" nan");
        } else {
            printf(" %016" PRIx64, bits);
        }
    }
    printf("\n");
}

static int read_number(NUMBER *to) {
    uint64_t bits;
    double wide;
    if (scanf("%" SCNx64, &bits) != 1) {
        return 0;
    }
    memcpy(&wide, &bits, sizeof wide);
    *to = (NUMBER)wide;
    return 1;
}

static void read_cases(void) {
    while (count < CASES && read_number(&q[count * DOF])) {
        int i;
        for (i = 1; i < DOF; i++) {
            require(read_number(&q[count * DOF + (size_t)i]), "a joint value");
        }
        for (i = 0; i < TARGET; i++) {
            require(read_number(&targets[count * TARGET + (size_t)i]), "a target");
        }
        for (i = 0; i < GIVEN; i++) {
            require(read_number(&given[count * GIVEN + (size_t)i]), "a given value");
        }
        count++;
    }
}

static void print_forward(void) {
    static NUMBER pose[16], frames[DOF * 16], jacobian[6 * DOF], poses[CASES * 16], jacobians[CASES * 6 * DOF];
    size_t i;
    for (i = 0; i < count; i++) {
        const NUMBER *at = q + i * DOF;
        require(CALL(forward)(SELF at, pose) == 0, "forward");
        numbers("forward", pose, 16);
        require(CALL(frames)(SELF at, frames) == 0, "frames");
        numbers("frames", frames, DOF * 16);
        require(CALL(jacobian)(SELF at, jacobian) == 0, "jacobian");
        numbers("jacobian", jacobian, 6 * DOF);
        require(CALL(forward_and_jacobian)(SELF at, pose, jacobian) == 0, "both");
        numbers("both", pose, 16);
        numbers("and", jacobian, 6 * DOF);
        printf("in range %d\n", TYPE(in_range)(at));
    }
    require(CALL(forward_batch)(SELF q, count, poses) == 0, "forward_batch");
    numbers("forward_batch", poses, count * 16);
    require(CALL(jacobian_batch)(SELF q, count, jacobians) == 0, "jacobian_batch");
    numbers("jacobian_batch", jacobians, count * 6 * DOF);
    /* In place: a pose has more numbers than these arms have joints. */
    memcpy(pose, q, DOF * sizeof(NUMBER));
    require(CALL(forward)(SELF pose, pose) == 0 && (pose[0] != pose[0] || pose[0] == poses[0]), "forward in place");
}

static void null_forward(void) {
    NUMBER some[16 * DOF + 16] = {7};
    require(CALL(forward)(SELF NULL, some) == NULL_POINTER && CALL(forward)(SELF q, NULL) == NULL_POINTER, "forward");
    require(CALL(frames)(SELF NULL, some) == NULL_POINTER && CALL(frames)(SELF q, NULL) == NULL_POINTER, "frames");
    require(CALL(jacobian)(SELF NULL, some) == NULL_POINTER && CALL(jacobian)(SELF q, NULL) == NULL_POINTER, "jacobian");
    require(CALL(forward_and_jacobian)(SELF q, some, NULL) == NULL_POINTER, "both");
    require(CALL(forward_and_jacobian)(SELF q, NULL, some) == NULL_POINTER, "both");
    require(CALL(forward_batch)(SELF NULL, 1, some) == NULL_POINTER, "forward_batch");
    require(CALL(forward_batch)(SELF NULL, 0, NULL) == 0 && CALL(jacobian_batch)(SELF NULL, 0, NULL) == 0, "nothing");
    require(CALL(jacobian_batch)(SELF q, 1, NULL) == NULL_POINTER && TYPE(in_range)(NULL) == NULL_POINTER, "others");
    require(some[0] == 7, "nothing was written");
#ifdef WITH
    require(CALL(forward)(NULL, q, some) == NULL_POINTER && some[0] == 7, "parameters");
#endif
}

#ifndef NO_INVERSE
static void print_solution(const TYPE(solution) *s) {
    char text[200];
    size_t length = TYPE(branch_text)(s->branch, text, sizeof text);
    require(length == strlen(text), "the length of a branch's text");
    numbers("  q", s->q, DOF);
    printf("  %016" PRIx64 " %s; %d %d %d %d; free %x\n", s->branch, text, TYPE(shoulder)(s->branch), TYPE(elbow)(s->branch),
        TYPE(wrist)(s->branch), TYPE(alternative)(s->branch, 0), (unsigned)s->free_joints);
}

static void print_why(const TYPE(why) *why) {
    char text[200], part[8];
    size_t length = TYPE(why_text)(why, text, sizeof text);
    require(length == strlen(text) && TYPE(why_text)(why, NULL, 0) == length, "the length of a reason's text");
    require(TYPE(why_text)(why, part, sizeof part) == length && strncmp(part, text, 7) == 0, "a part");
    require(strlen(part) == (length < 7 ? length : 7), "the end of a part");
    printf("  why %d: %s\n", why->code, text);
}

static void print_inverse(void) {
    static TYPE(solution) all[CASES * MOST], one, solutions[MOST];
    static TYPE(why) reasons[CASES], why;
    static int counts[CASES];
    size_t i, j;
    int found;
    for (i = 0; i < count; i++) {
        const NUMBER *target = targets + i * TARGET;
        found = CALL(inverse)(SELF target, PASS(given + i * GIVEN) solutions, &why);
        printf("inverse %d\n", found);
        for (j = 0; (int)j < found; j++) {
            print_solution(&solutions[j]);
        }
        print_why(&why);
        require(CALL(inverse)(SELF target, PASS(given + i * GIVEN) solutions, NULL) == found, "without a reason");
        found = CALL(inverse_near)(SELF target, PASS(given + i * GIVEN) q + i * DOF, &one, &why);
        printf("near %d\n", found);
        if (found == 1) {
            print_solution(&one);
        }
        print_why(&why);
        require(CALL(inverse_near)(SELF target, PASS(given + i * GIVEN) q + i * DOF, &one, NULL) == found, "near");
    }
    require(CALL(inverse_batch)(SELF targets, PASS_ALL(given) count, all, counts, reasons) == 0, "inverse_batch");
    for (i = 0; i < count; i++) {
        printf("batch %d\n", counts[i]);
        for (j = 0; (int)j < counts[i]; j++) {
            print_solution(&all[i * MOST + j]);
        }
        print_why(&reasons[i]);
    }
}

static void null_inverse(void) {
    TYPE(solution) some[MOST];
    TYPE(why) why = {0, 0, 0, 0, 0};
    char text[4] = "abc";
    int found[1];
    some[0].q[0] = 7;
    require(CALL(inverse)(SELF NULL, PASS(given) some, &why) == NULL_POINTER, "inverse");
    require(CALL(inverse)(SELF targets, PASS(given) NULL, &why) == NULL_POINTER, "inverse");
    require(CALL(inverse_near)(SELF NULL, PASS(given) q, some, &why) == NULL_POINTER, "inverse_near");
    require(CALL(inverse_near)(SELF targets, PASS(given) NULL, some, &why) == NULL_POINTER, "inverse_near");
    require(CALL(inverse_near)(SELF targets, PASS(given) q, NULL, &why) == NULL_POINTER, "inverse_near");
    require(CALL(inverse_batch)(SELF NULL, PASS_ALL(given) 1, some, found, &why) == NULL_POINTER, "inverse_batch");
    require(CALL(inverse_batch)(SELF targets, PASS_ALL(given) 1, NULL, found, &why) == NULL_POINTER, "inverse_batch");
    require(CALL(inverse_batch)(SELF targets, PASS_ALL(given) 1, some, NULL, &why) == NULL_POINTER, "inverse_batch");
    require(CALL(inverse_batch)(SELF NULL, PASS_ALL(NULL) 0, NULL, NULL, NULL) == 0, "no target");
#if GIVEN > 0
    require(CALL(inverse_batch)(SELF targets, NULL, 1, some, found, &why) == NULL_POINTER, "inverse_batch");
#endif
    require(some[0].q[0] == 7, "nothing was written");
    require(TYPE(why_text)(NULL, text, sizeof text) == 0 && text[0] == 0, "no reason");
    /* Numbers that no function writes: a sentence all the same. */
    why.code = 5;
    why.step = 12345;
    why.unit = -7;
    require(TYPE(why_text)(&why, NULL, 0) > 0 && TYPE(branch_text)(~(uint64_t)0, NULL, 0) > 0, "made-up values");
    why.code = -99;
    require(TYPE(why_text)(&why, text, 1) > 0 && text[0] == 0, "one byte");
}
#endif

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

/* The least time of a call in some rounds over all cases, in nanoseconds. */
#define TIME(name, call)                                              \
    do {                                                              \
        double least = 1e30;                                          \
        int round;                                                    \
        for (round = 0; round < 40; round++) {                        \
            double start = now();                                     \
            for (i = 0; i < count; i++) {                             \
                call;                                                 \
            }                                                         \
            if ((now() - start) / (double)count < least) {            \
                least = (now() - start) / (double)count;              \
            }                                                         \
        }                                                             \
        printf("%s %.1f\n", name, least);                             \
    } while (0)

static void times(void) {
    static NUMBER pose[CASES * 16], jacobian[CASES * 6 * DOF], frames[DOF * 16];
    size_t i;
    TIME("forward", CALL(forward)(SELF q + i * DOF, pose + i * 16));
    TIME("frames", CALL(frames)(SELF q + i * DOF, frames));
    TIME("jacobian", CALL(jacobian)(SELF q + i * DOF, jacobian + i * 6 * DOF));
    TIME("forward_batch", if (i == 0) CALL(forward_batch)(SELF q, count, pose));
#ifndef NO_INVERSE
    {
        static TYPE(solution) solutions[MOST];
        static TYPE(why) why;
        TIME("inverse", CALL(inverse)(SELF targets + i * TARGET, PASS(given + i * GIVEN) solutions, &why));
        TIME("near", CALL(inverse_near)(SELF targets + i * TARGET, PASS(given + i * GIVEN) q + i * DOF, solutions, &why));
    }
#endif
}

int main(int argc, char **argv) {
#ifdef WITH
    NUMBER *fields = (NUMBER *)&params;
    size_t k;
#ifdef NOMINAL
    params = TYPE(nominal)();
#endif
    for (k = 0; k < sizeof params / sizeof(NUMBER); k++) {
#ifdef NOMINAL
        fields[k] += (NUMBER)0.0078125 * (NUMBER)(k + 1);
#else
        fields[k] = (NUMBER)0.25 * (NUMBER)(k + 1);
#endif
    }
#endif
    (void)argv;
    read_cases();
    require(count > 0, "there are cases");
    if (argc > 1) {
        times();
        return 0;
    }
    null_forward();
    print_forward();
#ifndef NO_INVERSE
    null_inverse();
    print_inverse();
#endif
    return 0;
}
