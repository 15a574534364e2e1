// Writes down the rays of chosen pixels, one JSON object a line, for `groundtruth rays` (docs/rays.md). C# 7 and later.
//
//   RAYS=120,80 dotnet run    writes rays.jsonl: the rays of that pixel; RAYS="120,80;121,80" of two,
//                             RAYS=10x10+120+80 of a block, RAYS=/16 of each 16th column and row
//   RAYS_FILE=other.jsonl     to another file
//
//   Rays.Pixel(x, y, sample);                                       // before the camera's ray of a sample
//   using (var log = Rays.Begin("reflected", origin, direction)) {  // where a ray begins: camera, reflected, diffuse,
//                                                    // transmitted, path, shadow; the ray around it is its parent
//       log.Hit(t, point, normal, "ball");                          // where it ends; not called if it hits nothing
//       log.Number("pdf", pdf); log.Color("weight", w);             // what else is known: see docs/rays.md
//       log.Color("radiance", L);                                   // what it brings back
//   }                                                               // here the line is written
// Vectors are arrays, or have X, Y, Z (or R, G, B) as fields or properties. Without RAYS a call tests a bool.
using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text;
using System.Text.RegularExpressions;

public static class Rays
{
    static readonly List<int[]> chosen = new List<int[]>();     // x, y, width, height, step
    static readonly StreamWriter file = Open();
    static readonly Ray nothing = new Ray(null);
    [ThreadStatic] static State state;
    // of a thread: whether it is in a chosen pixel, the next ray's number, and that of the ray around it
    internal class State { public bool On; public int X, Y, Sample, Next, Open = -1; }

    static StreamWriter Open()
    {
        var pattern = new Regex(@"^(?:(?:(\d+)x(\d+)\+)?(\d+)[,+](\d+)|/(0*[1-9]\d*))$");
        foreach (var item in (Environment.GetEnvironmentVariable("RAYS") ?? "").Split(';').Where(it => it != ""))
        {
            var found = pattern.Match(item.Trim());
            Func<int, int, int> number = (i, other) => found.Groups[i].Success ? int.Parse(found.Groups[i].Value) : other;
            int far = found.Groups[5].Success ? 1 << 30 : 1;
            chosen.Add(new[] { number(3, 0), number(4, 0), number(1, far), number(2, far), number(5, 1) });
            if (found.Success) continue;
            Console.Error.WriteLine("rays: RAYS is x,y or WxH+X+Y or /N, or several with ';', not " + item);
            return null;
        }
        if (chosen.Count == 0) return null;
        try
        {
            var log = new StreamWriter(Environment.GetEnvironmentVariable("RAYS_FILE") ?? "rays.jsonl") { AutoFlush = true };
            log.Write("{\"rays\": 1}\n");
            return log;
        }
        catch (Exception e) { Console.Error.WriteLine("rays: " + e.Message); return null; }
    }

    // A line of its own: {"object": "ball", "sphere": {"center": [0, 1, 0], "radius": 1}} or {"lamp": "sun", ...}.
    public static void Line(string json) { if (file != null) lock (file) file.Write(json + "\n"); }

    public static void Pixel(int x, int y, int sample)
    {
        if (file == null) return;
        Func<int, int, int, bool> isIn = (at, length, step) => at >= 0 && at < length && at % step == 0;
        var on = chosen.Any(b => isIn(x - b[0], b[2], b[4]) && isIn(y - b[1], b[3], b[4]));
        state = new State { On = on, X = x, Y = y, Sample = sample };
    }

    public static Ray Begin<P, V>(string kind, P origin, V direction)
    {
        if (file == null || state == null || !state.On) return nothing;
        var ray = new Ray(state);
        ray.Text("kind", kind); ray.Color("origin", origin); ray.Color("direction", direction); return ray;
    }

    static string Print(object x) => Convert.ToDouble(x).ToString("G17", CultureInfo.InvariantCulture);

    static string Component(object v, int i)
    {
        if (v is Array array) return Print(array.GetValue(i));
        if (v is IConvertible) return Print(v);
        const BindingFlags any = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.IgnoreCase;
        foreach (var name in new[] { "xyz".Substring(i, 1), "rgb".Substring(i, 1) })
        {
            if (v.GetType().GetField(name, any) is FieldInfo field) return Print(field.GetValue(v));
            if (v.GetType().GetProperty(name, any) is PropertyInfo property) return Print(property.GetValue(v));
        }
        throw new ArgumentException("rays: " + v.GetType() + " has no X, Y, Z");
    }

    public sealed class Ray : IDisposable
    {
        readonly State state;
        readonly int own, before;
        readonly StringBuilder line = new StringBuilder();

        internal Ray(State state)
        {
            this.state = state;
            if (state == null) return;
            own = state.Next++; before = state.Open; state.Open = own;
            line.Append("{\"pixel\": [" + state.X + ", " + state.Y + "], \"sample\": " + state.Sample + ", \"ray\": " + own);
            if (before >= 0) Put("parent", "" + before);
        }
        void Put(string field, string json) => line.Append(", \"" + field + "\": " + json);
        public void Number(string field, double x) { if (state != null) Put(field, Print(x)); }
        public void Flag(string field, bool x) { if (state != null) Put(field, x ? "true" : "false"); }
        public void Color<V>(string field, V v)
        {
            if (state != null) Put(field, "[" + Component(v, 0) + ", " + Component(v, 1) + ", " + Component(v, 2) + "]");
        }
        public void Text(string field, string value)
        {
            if (state == null || value == null) return;
            var text = value.Select(c => c == '"' || c == '\\' ? "\\" + c : c < 32 ? "\\u" + ((int)c).ToString("x4") : "" + c);
            Put(field, '"' + string.Concat(text) + '"');
        }
        public void Hit<P, V>(double t, P point, V normal, string name = null)
        { Number("t", t); Color("point", point); Color("normal", normal); Text("object", name); }
        public void Dispose() { if (state != null) { if (state.Open >= own) state.Open = before; Line(line + "}"); } }
    }
}
