// Writes down the rays of chosen pixels, one JSON object a line, for `groundtruth rays` (docs/rays.md). Java 8 and later.
//
//   RAYS=120,80 java Tracer    writes rays.jsonl: the rays of that pixel; RAYS="120,80;121,80" of two,
//                              RAYS=10x10+120+80 of a block, RAYS=/16 of each 16th column and row
//   RAYS_FILE=other.jsonl      to another file
//
//   Rays.pixel(x, y, sample);                                           // before the camera's ray of a sample
//   try (Rays.Ray log = Rays.ray("reflected", origin, direction)) {     // where a ray begins: camera, reflected, diffuse,
//                                                   // transmitted, path, shadow; the ray around it is its parent
//       log.hit(t, point, normal, "ball");                              // where it ends; not called if it hits nothing
//       log.number("pdf", pdf); log.color("weight", w);                 // what else is known: see docs/rays.md
//       log.color("radiance", L);                                       // what it brings back
//   }                                                                   // here the line is written
// Vectors are arrays, or have x, y, z (or r, g, b) as fields or methods. Without RAYS a call tests a boolean.
import java.io.IOException;
import java.io.PrintStream;
import java.lang.reflect.*;
import java.util.*;
import java.util.regex.*;

public final class Rays {
    private static final List<int[]> chosen = new ArrayList<>();        // x, y, width, height, step
    private static final PrintStream out = open();
    private static final ThreadLocal<State> state = ThreadLocal.withInitial(State::new);
    private static final Ray nothing = new Ray(null, null, null, null);
    private static final class State { boolean on; int x, y, sample, next, open; }      // of a thread; the ray around the next

    private static PrintStream open() {
        String pixels = System.getenv("RAYS"), name = System.getenv("RAYS_FILE");
        Pattern pattern = Pattern.compile("(\\d+),(\\d+)|(\\d+)x(\\d+)\\+(\\d+)\\+(\\d+)|/(0*[1-9]\\d*)");
        for (String item : (pixels == null ? "" : pixels).split(";")) {
            Matcher found = pattern.matcher(item.trim());
            if (item.isEmpty()) continue;
            if (!found.matches()) {
                System.err.println("rays: RAYS is x,y or WxH+X+Y or /N, or several with ';', not " + item);
                return null;
            }
            int[] n = new int[8];
            for (int i = 1; i < 8; i++) n[i] = found.group(i) == null ? 0 : Integer.parseInt(found.group(i));
            chosen.add(n[7] > 0 ? new int[] {0, 0, 1 << 30, 1 << 30, n[7]} : found.group(1) != null
                ? new int[] {n[1], n[2], 1, 1, 1} : new int[] {n[5], n[6], n[3], n[4], 1});
        }
        try {
            PrintStream file = chosen.isEmpty() ? null : new PrintStream(name == null ? "rays.jsonl" : name, "UTF-8");
            if (file != null) file.print("{\"rays\": 1}\n");
            return file;
        } catch (IOException e) { System.err.println("rays: " + e); return null; }
    }

    /** A line of its own: {"object": "ball", "sphere": {"center": [0, 1, 0], "radius": 1}} or {"lamp": "sun", ...}. */
    public static void line(String json) { if (out != null) out.print(json + "\n"); }

    public static void pixel(int x, int y, int sample) {
        if (out == null) return;
        State s = state.get(); s.x = x; s.y = y; s.sample = sample; s.next = 0; s.open = -1; s.on = false;
        for (int[] b : chosen) s.on |= x >= b[0] && y >= b[1] && x - b[0] < b[2] && y - b[1] < b[3]
            && (x - b[0]) % b[4] == 0 && (y - b[1]) % b[4] == 0;
    }

    public static Ray ray(String kind, Object origin, Object direction) {
        return out == null || !state.get().on ? nothing : new Ray(state.get(), kind, origin, direction);
    }

    private static double at(Object v, int i) {
        if (v instanceof Number) return ((Number) v).doubleValue();
        if (v.getClass().isArray()) return Array.getDouble(v, i);
        String letter = "xyz".substring(i, i + 1);
        List<String> names = Arrays.asList(letter, "get" + letter.toUpperCase(), "rgb".substring(i, i + 1));
        try {
            for (Class<?> c = v.getClass(); c != null; c = c.getSuperclass()) {
                List<Member> members = new ArrayList<>(Arrays.asList(c.getDeclaredMethods()));
                members.addAll(Arrays.asList(c.getDeclaredFields()));
                for (Member m : members) {
                    if (!names.contains(m.getName()) || m instanceof Method && ((Method) m).getParameterCount() > 0) continue;
                    ((AccessibleObject) m).setAccessible(true);
                    return ((Number) (m instanceof Method ? ((Method) m).invoke(v) : ((Field) m).get(v))).doubleValue();
                }
            }
        } catch (ReflectiveOperationException e) { throw new IllegalArgumentException(e); }
        throw new IllegalArgumentException("rays: " + v.getClass() + " has no x, y, z");
    }

    public static final class Ray implements AutoCloseable {
        private final State state;
        private int own, before;
        private final StringBuilder line = new StringBuilder();

        private Ray(State state, String kind, Object origin, Object direction) {
            this.state = state;
            if (state == null) return;
            own = state.next++; before = state.open; state.open = own;
            put("pixel", "[" + state.x + ", " + state.y + "]"); put("sample", state.sample); put("ray", own);
            if (before >= 0) put("parent", before);
            text("kind", kind); color("origin", origin); color("direction", direction);
        }
        private void put(String field, Object json) {
            line.append(line.length() == 0 ? "{\"" : ", \"").append(field).append("\": ").append(json);
        }
        public void number(String field, double x) { if (state != null) put(field, x); }
        public void flag(String field, boolean x) { if (state != null) put(field, x); }
        public void color(String field, Object v) {
            if (state != null) put(field, "[" + at(v, 0) + ", " + at(v, 1) + ", " + at(v, 2) + "]");
        }
        public void text(String field, String value) {
            if (state == null || value == null) return;
            StringBuilder text = new StringBuilder("\"");
            for (char c : value.toCharArray())
                text.append(c == '"' || c == '\\' ? "\\" + c : c < 32 ? String.format("\\u%04x", (int) c) : "" + c);
            put(field, text.append('"'));
        }
        public void hit(double t, Object point, Object normal, String object) {
            number("t", t); color("point", point); color("normal", normal); text("object", object);
        }
        @Override public void close() {
            if (state != null && state.open >= own) state.open = before;
            if (state != null) line(line.append("}").toString());
        }
    }
}
