// Answers the questions of `groundtruth laws`: name your lobes, and fill in two functions.
//
// Build: javac MyBsdfs.java   (Java 11 or later; this file as MyBsdfs.java, beside your own classes)
// Run:   groundtruth laws -- java MyBsdfs
//
// docs/laws.md describes the questions and the claims, and examples/laws/bsdfs.py is one with more lobes.
// All directions are unit vectors in the local frame of the surface: z is the normal. `wo` points to the viewer, `wi`
// to the light. The lobe below is Lambert's; put yours in its place.
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

class MyBsdfs {
    // What you have: names, from where parameters are drawn, and what you claim. A claim that is left out is not tested.
    // [0, 1] is a range; {"one_of": ["copper", "gold"]} chooses, a number is fixed.
    static final String LOBES = "[{\"name\": \"lambert\", \"parameters\": {\"albedo\": [0, 1]},"
        + " \"claims\": {\"reciprocal\": true, \"isotropic\": true}}]";

    // f(wo, wi), without a cosine, as three numbers; and last the density of `sample` at wi, per steradian
    static double[] evaluate(String name, Json parameters, double[] wo, double[] wi) {
        if (wo[2] <= 0 || wi[2] <= 0) return new double[] {0, 0, 0, 0};
        double f = parameters.get("albedo").real() / Math.PI;
        return new double[] {f, f, f, wi[2] / Math.PI};
    }

    // For four random numbers in [0, 1): a direction, its weight f |cos| / pdf, and its density, null for a single
    // direction; null for no sample at all
    static Object sample(String name, Json parameters, double[] wo, double[] u) {
        if (wo[2] <= 0) return null;
        double r = Math.sqrt(u[0]), phi = 2 * Math.PI * u[1], albedo = parameters.get("albedo").real();
        double[] wi = {r * Math.cos(phi), r * Math.sin(phi), Math.sqrt(1 - u[0])};
        return object("wi", wi, "weight", new double[] {albedo, albedo, albedo}, "pdf", wi[2] / Math.PI);
    }

    // The protocol: a question is a line, and so is its answer, with the same id.

    static Object answer(Json question) {
        if (question.has("list")) return new Reader(LOBES).value();
        boolean isEval = question.has("eval");
        Json data = question.get(isEval ? "eval" : "sample");
        String name = (String) data.get("lobe").value;
        Json parameters = data.get("parameters");
        double[] wo = data.get("wo").reals();
        List<Object> first = new ArrayList<>(), second = new ArrayList<>();
        if (!isEval) {
            for (Json u : data.get("u").items()) first.add(sample(name, parameters, wo, u.reals()));
            return first;
        }
        for (Json wi : data.get("wi").items()) {
            double[] value = evaluate(name, parameters, wo, wi.reals());
            first.add(new double[] {value[0], value[1], value[2]});
            second.add(value[3]);
        }
        return object("f", first, "pdf", second);
    }

    static String reply(String line) {
        Json question = new Reader(line).value();
        Object id = question.get("id").value;
        try {
            return text(object("id", id, "answer", answer(question)));
        } catch (RuntimeException | StackOverflowError error) {  // shown on the card
            return text(object("id", id, "error", error.toString()));
        }
    }

    public static void main(String[] arguments) throws IOException {
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        // flushes at each line: a pipe keeps lines back. Print nothing else here: messages belong to System.err
        PrintStream out = new PrintStream(System.out, true, "UTF-8");
        for (String line = in.readLine(); line != null; line = in.readLine()) out.println(reply(line));
    }

@JSON@
