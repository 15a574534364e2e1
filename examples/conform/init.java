// Answers the questions of `groundtruth conform`: fill in what your ray tracer has.
//
// Build: javac MyTracer.java   (Java 11 or later; this file as MyTracer.java, beside your own classes)
// Run:   groundtruth conform -- java MyTracer
//
// docs/probe.md describes the questions, docs/conform.md the run; examples/conform/adapter.cpp and adapter.py are
// filled in.
// What you do not have is unsupported: throw Unsupported, also for one shape among others. A function that is filled
// in begins, for example, with
//     double[] origin = q.get("ray").get("origin").reals();
// and ends with
//     return object("t", t, "normal", normal);
// Answers are null, true or false, numbers, texts, double[], lists, and objects.
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

class MyTracer {
    // The questions: each function gets a question's data and returns the answer.

    // {"shape": …, "ray": {"origin": […], "direction": […]}} -> {"t": …, "normal": […]} or null
    static Object intersect(Json q) { throw new Unsupported("intersect"); }

    // {"shape": …, "segment": {"from": […], "to": […]}} -> true or false
    static Object occluded(Json q) { throw new Unsupported("occluded"); }

    // {"camera": …, "image": …, "pixel": [x, y]} -> {"origin": […], "direction": […]}
    static Object cameraRay(Json q) { throw new Unsupported("camera_ray"); }

    // {"camera": …, "image": …, "point": […]} -> {"image": [x, y]} or null
    static Object project(Json q) { throw new Unsupported("project"); }

    // {"sampler": …, "n": 16, "seed": 1, "sets": 2} -> [[[x, y], …], …]
    static Object samples(Json q) { throw new Unsupported("samples"); }

    // {"to": …, "u": [a, b]} -> a point; {"to": …, "point": […]} -> [a, b]
    static Object map(Json q) { throw new Unsupported("map"); }

    // {"lobe": …, "wo": […], "wi": […]} -> {"f": [r, g, b], "pdf": …, "albedo": [r, g, b]}
    static Object lobe(Json q) { throw new Unsupported("lobe"); }

    // {"eta": …, "cos_i": …} -> {"reflected": …, "transmitted": …}
    static Object fresnel(Json q) { throw new Unsupported("fresnel"); }

    // {"light": …, "from": […]} -> {"direction": […], "distance": …, "radiance": [r, g, b]}
    static Object light(Json q) { throw new Unsupported("light"); }

    // {"texture": …, "point": […]} -> [r, g, b]
    static Object texture(Json q) { throw new Unsupported("texture"); }

    // {"mapping": "spherical", "point": […]} -> [u, v]
    static Object mapping(Json q) { throw new Unsupported("mapping"); }

    // {"noise": …, "point": […]} -> {"value": …, "fbm": …, "turbulence": …}
    static Object noise(Json q) { throw new Unsupported("noise"); }

    // {"steps": […]} -> {"matrix": [three rows of four], "inverse": [three rows of four]}
    static Object transform(Json q) { throw new Unsupported("transform"); }

    // {"boxes": […], "multiplier": 2} -> {"resolution": [nx, ny, nz]}
    static Object grid(Json q) { throw new Unsupported("grid"); }

    // {"scene": …, "ray": …} -> {"mean": [r, g, b]}
    static Object radiance(Json q) { throw new Unsupported("radiance"); }

    // {"scene": …, "ray": …} -> {"radiance": [r, g, b], "rays": [{"kind": "camera", "origin": …, "direction": …}, …]}
    static Object trace(Json q) { throw new Unsupported("trace"); }

    // The protocol: a question is a line, and so is its answer, with the same id.

    static Object answer(String name, Json q) {
        switch (name) {
            case "intersect": return intersect(q);
            case "occluded": return occluded(q);
            case "camera_ray": return cameraRay(q);
            case "project": return project(q);
            case "samples": return samples(q);
            case "map": return map(q);
            case "lobe": return lobe(q);
            case "fresnel": return fresnel(q);
            case "light": return light(q);
            case "texture": return texture(q);
            case "mapping": return mapping(q);
            case "noise": return noise(q);
            case "transform": return transform(q);
            case "grid": return grid(q);
            case "radiance": return radiance(q);
            case "trace": return trace(q);
            default: throw new Unsupported(name);
        }
    }

    static class Unsupported extends RuntimeException {
        private static final long serialVersionUID = 1;

        Unsupported(String what) { super(what); }
    }

    static String reply(String line) {
        Json question = new Reader(line).value();
        Object id = question.get("id").value;
        String name = "";
        for (String key : question.keys()) if (!key.equals("id")) name = key;
        try {
            return text(object("id", id, "answer", answer(name, question.get(name))));
        } catch (Unsupported what) {
            return text(object("id", id, "unsupported", what.getMessage()));
        } catch (RuntimeException | StackOverflowError error) {  // shown on the card; the next one is answered
            return text(object("id", id, "error", error.toString()));
        }
    }

    public static void main(String[] arguments) throws IOException {
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        // flushes at each line: a pipe keeps lines back. Print nothing else here: messages belong to System.err
        PrintStream out = new PrintStream(System.out, true, "UTF-8");
        for (String line = in.readLine(); line != null; line = in.readLine()) out.println(reply(line));
    }

    // JSON: a value is null, a Boolean, a Double, a String, a List of Json, or a Map from names to Json.

    static class Json {
        final Object value;

        Json(Object value) { this.value = value; }

        boolean has(String key) { return value instanceof Map && ((Map<?, ?>) value).containsKey(key); }

        Json get(String key) {
            if (!has(key)) throw new RuntimeException("no field " + key);
            return (Json) ((Map<?, ?>) value).get(key);
        }

        List<String> keys() {
            List<String> all = new ArrayList<>();
            if (value instanceof Map) for (Object key : ((Map<?, ?>) value).keySet()) all.add((String) key);
            return all;
        }

        List<Json> items() {
            List<Json> all = new ArrayList<>();
            if (value instanceof List) for (Object item : (List<?>) value) all.add((Json) item);
            return all;
        }

        boolean truth(String key) { return has(key) && Boolean.TRUE.equals(get(key).value); }

        double real() {  // "inf", too
            if ("inf".equals(value)) return Double.POSITIVE_INFINITY;
            if ("-inf".equals(value)) return Double.NEGATIVE_INFINITY;
            return (Double) value;
        }

        double real(String key, double otherwise) { return has(key) ? get(key).real() : otherwise; }

        double[] reals() { return items().stream().mapToDouble(Json::real).toArray(); }
    }

    static class Reader {
        final String line;
        int at = 0;

        Reader(String line) { this.line = line; }

        char next() {
            while (at < line.length() && line.charAt(at) == ' ') ++at;
            return at < line.length() ? line.charAt(at) : 0;
        }

        boolean skip(char c) {
            boolean is = next() == c;
            if (is) ++at;
            return is;
        }

        boolean word(String word) {
            boolean is = line.startsWith(word, at);
            if (is) at += word.length();
            return is;
        }

        String text() {  // names have no escapes but of quotes
            StringBuilder text = new StringBuilder();
            for (skip('"'); line.charAt(at) != '"'; ++at) text.append(line.charAt(at) == '\\' ? line.charAt(++at) : line.charAt(at));
            skip('"');
            return text.toString();
        }

        Json value() {
            if (skip('{')) {
                Map<String, Json> fields = new LinkedHashMap<>();
                for (; !skip('}'); skip(',')) {
                    next();
                    String key = text();
                    skip(':');
                    fields.put(key, value());
                }
                return new Json(fields);
            }
            if (skip('[')) {
                List<Json> items = new ArrayList<>();
                for (; !skip(']'); skip(',')) items.add(value());
                return new Json(items);
            }
            if (next() == '"') return new Json(text());
            if (word("true")) return new Json(true);
            if (word("false")) return new Json(false);
            if (word("null")) return new Json(null);
            int begin = at;
            while (at < line.length() && "+-.0123456789eE".indexOf(line.charAt(at)) >= 0) ++at;
            return new Json(Double.parseDouble(line.substring(begin, at)));
        }
    }

    // object("t", 1.5, "normal", n) is {"t": 1.5, "normal": …}
    static Map<String, Object> object(Object... keysAndValues) {
        Map<String, Object> fields = new LinkedHashMap<>();
        for (int i = 0; i < keysAndValues.length; i += 2) fields.put((String) keysAndValues[i], keysAndValues[i + 1]);
        return fields;
    }

    // Numbers get as many digits as lead back to them.
    static String text(Object answer) {
        if (answer instanceof Json) return text(((Json) answer).value);
        if (answer == null || answer instanceof Boolean) return String.valueOf(answer);
        if (answer instanceof Number) {
            double x = ((Number) answer).doubleValue();
            if (Double.isInfinite(x)) return x > 0 ? "\"inf\"" : "\"-inf\"";
            return Double.isNaN(x) ? "\"nan\"" : answer.toString();
        }
        List<String> parts = new ArrayList<>();
        if (answer instanceof double[]) {
            for (double x : (double[]) answer) parts.add(text(x));
            return "[" + String.join(",", parts) + "]";
        }
        if (answer instanceof List) {
            for (Object item : (List<?>) answer) parts.add(text(item));
            return "[" + String.join(",", parts) + "]";
        }
        if (answer instanceof Map) {
            for (Map.Entry<?, ?> field : ((Map<?, ?>) answer).entrySet()) parts.add(text(field.getKey()) + ":" + text(field.getValue()));
            return "{" + String.join(",", parts) + "}";
        }
        StringBuilder words = new StringBuilder("\"");
        for (char c : answer.toString().toCharArray()) words.append(c == '"' || c == '\\' || c < ' ' ? '\'' : c);
        return words.append('"').toString();
    }
}
