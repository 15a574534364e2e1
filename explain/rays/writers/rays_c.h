/* Writes down the rays of chosen pixels, one JSON object a line, for `groundtruth rays` (docs/rays.md). C99 and later.

   RAYS=120,80 ./my_tracer    writes rays.jsonl: the rays of that pixel; RAYS="120,80;121,80" of two,
                              RAYS=10x10+120+80 of a block, RAYS=/16 of each 16th column and row
   RAYS_FILE=other.jsonl      to another file

   #define RAYS_IMPLEMENTATION before the #include, in one file of the program
   rays_pixel(x, y, sample);                                     before the camera's ray of a sample
   rays_log log = rays_begin("reflected", origin, direction);    where a ray begins: camera, reflected, transmitted,
                                                                 diffuse, path, shadow; a child of the one that is open
   rays_hit(&log, t, point, normal, "ball");                     where it ends; not called if it hits nothing
   rays_number(&log, "pdf", pdf); rays_color(&log, "weight", w); what else is known: see docs/rays.md
   rays_end(&log);                                               before each `return`: writes the line
   Vectors have .x, .y and .z; for others #define RAYS_XYZ(v) before the #include. Without RAYS a call tests an int. */
#ifndef RAYS_C_H
#define RAYS_C_H
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifndef RAYS_XYZ
#define RAYS_XYZ(v) (v).x, (v).y, (v).z /* or (v)[0], (v)[1], (v)[2] */
#endif
#ifdef _MSC_VER
#include <intrin.h>
#define RAYS_THREAD __declspec(thread)
#define RAYS_SWAP(at, old, with) _InterlockedCompareExchange(at, with, old)
#else
#define RAYS_THREAD __thread
#define RAYS_SWAP(at, old, with) __sync_val_compare_and_swap(at, old, with)
#endif
typedef struct { int on, x, y, sample; long next, open; } rays_state;
typedef struct { int on; long own, before; char *line; size_t used, room; } rays_log;
extern RAYS_THREAD rays_state rays_now; /* whether this thread is in a chosen pixel; its next ray, the ray that is open */
static const rays_log rays_off = {0, 0, 0, 0, 0, 0};

/* a line of its own, as {"object": "ball", "sphere": {"center": [0, 1, 0], "radius": 1}} or {"lamp": "sun", ...} */
void rays_line(const char *json), rays_pixel(int x, int y, int sample);
#define rays_begin(kind, o, d) (rays_now.on ? rays_first(kind, RAYS_XYZ(o), RAYS_XYZ(d)) : rays_off)
#define rays_number(log, field, x) ((log)->on ? rays_print(log, field, 1, x, 0, 0) : (void)0)
#define rays_color(log, field, v) ((log)->on ? rays_print(log, field, 3, RAYS_XYZ(v)) : (void)0)
#define rays_flag(log, field, x) ((log)->on ? rays_word(log, field, (x) ? "true" : "false", 0) : (void)0)
#define rays_text(log, field, text) ((log)->on ? rays_word(log, field, text, 1) : (void)0)
#define rays_hit(log, t, p, n, object) \
    (rays_number(log, "t", t), rays_color(log, "point", p), rays_color(log, "normal", n), rays_text(log, "object", object))
#define rays_end(log) ((log)->on ? rays_last(log) : (void)0)
rays_log rays_first(const char *kind, double ox, double oy, double oz, double dx, double dy, double dz);
void rays_print(rays_log *log, const char *field, int count, double x, double y, double z);
void rays_word(rays_log *log, const char *field, const char *text, int quoted), rays_last(rays_log *log);
#endif

#ifdef RAYS_IMPLEMENTATION
RAYS_THREAD rays_state rays_now;
static void rays_put(rays_log *log, const char *text) {
    size_t end = log->used + strlen(text);
    if (end >= log->room) log->line = (char *)realloc(log->line, log->room = 2 * end + 500);
    strcpy(log->line + log->used, text);
    log->used = end;
}
static void rays_name(rays_log *log, const char *field) {
    rays_put(log, log->used ? ", \"" : "{\""); rays_put(log, field); rays_put(log, "\": ");
}
/* whether the first item of a selection has the pixel; `rest` moves past the item, unless it is none */
static int rays_has(const char **rest, int px, int py) {
    int x = 0, y = 0, width = 0, height = 0, step = 1, n = 0;
    if (sscanf(*rest, "%dx%d+%d+%d%n", &width, &height, &x, &y, &n) != 4) {
        if (sscanf(*rest, "/%d%n", &step, &n) == 1) width = height = 1 << 30;
        else if (sscanf(*rest, "%d,%d%n", &x, &y, &n) == 2) width = height = 1;
    }
    if (n == 0 || step < 1 || ((*rest)[n] && (*rest)[n] != ';')) return 0;
    *rest += n + ((*rest)[n] == ';');
    return px >= x && py >= y && px - x < width && py - y < height && (px - x) % step == 0 && (py - y) % step == 0;
}
static FILE *rays_file(void) { /* opened by whichever thread comes first; the others wait */
    static FILE *out; static long state; /* 0 not opened, 1 being opened, 2 opened */
    const char *rest = getenv("RAYS"), *name = getenv("RAYS_FILE"), *last = 0;
    long was;
    while ((was = RAYS_SWAP(&state, 0, 1)) == 1) {}
    if (was == 2) return out;
    while (rest && rest != last) { last = rest; rays_has(&rest, 0, 0); }
    if (rest && *rest) fprintf(stderr, "rays: RAYS is x,y or WxH+X+Y or /N, or several with ';', not %s\n", rest);
    else if (rest && *getenv("RAYS") && !(out = fopen(name ? name : "rays.jsonl", "w"))) perror("rays");
    if (out) fputs("{\"rays\": 1}\n", out);
    RAYS_SWAP(&state, 1, 2);
    return out;
}
void rays_line(const char *json) { if (rays_file()) { fprintf(rays_file(), "%s\n", json); fflush(rays_file()); } }
void rays_pixel(int x, int y, int sample) {
    rays_state now = {0, x, y, sample, 0, -1};
    const char *rest = rays_file() ? getenv("RAYS") : "";
    while (!now.on && *rest) now.on = rays_has(&rest, x, y);
    rays_now = now;
}
void rays_print(rays_log *log, const char *field, int count, double x, double y, double z) {
    static const char *const formats[] = {"%.17g", "[%.17g; %.17g]", "[%.17g; %.17g; %.17g]"};
    char text[100], *c;
    rays_name(log, field);
    sprintf(text, formats[count - 1], x, y, z);
    for (c = text; *c; ++c) *c = *c == ';' ? ',' : *c == ',' ? '.' : *c; /* some locales have a decimal comma */
    rays_put(log, text);
}
void rays_word(rays_log *log, const char *field, const char *text, int quoted) {
    char one[8];
    if (text) rays_name(log, field); else return;
    for (rays_put(log, quoted ? "\"" : ""); *text; rays_put(log, one), ++text)
        sprintf(one, (unsigned char)*text < 32 ? "\\u%04x" : strchr("\"\\", *text) ? "\\%c" : "%c", *text);
    rays_put(log, quoted ? "\"" : "");
}
rays_log rays_first(const char *kind, double ox, double oy, double oz, double dx, double dy, double dz) {
    rays_log log = {1, rays_now.next++, rays_now.open, 0, 0, 0};
    rays_now.open = log.own; rays_print(&log, "pixel", 2, rays_now.x, rays_now.y, 0);
    rays_number(&log, "sample", rays_now.sample); rays_number(&log, "ray", log.own);
    if (log.before >= 0) rays_number(&log, "parent", log.before);
    rays_text(&log, "kind", kind); rays_print(&log, "origin", 3, ox, oy, oz);
    rays_print(&log, "direction", 3, dx, dy, dz); return log;
}
void rays_last(rays_log *log) {
    if (rays_now.open >= log->own) rays_now.open = log->before;
    rays_put(log, "}"); rays_line(log->line); free(log->line);
}
#endif
