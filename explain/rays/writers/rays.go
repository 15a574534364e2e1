// Package rays writes down the rays of chosen pixels, one JSON object a line, for `groundtruth rays` (docs/rays.md).
//
//	RAYS=120,80 go run .     writes rays.jsonl: the rays of that pixel; RAYS="120,80;121,80" of two,
//	                         RAYS=10x10+120+80 of a block, RAYS=/16 of each 16th column and row
//	RAYS_FILE=other.jsonl    to another file
//
//	pixel := rays.Pixel(x, y, sample)                   // before the camera's ray of a sample
//	log := pixel.Ray("camera", origin, direction)       // where a ray begins; hand it to what traces the next ones:
//	next := log.Ray("reflected", origin, direction)     // also transmitted, diffuse, path, shadow; log is its parent
//	defer next.End()                                    // writes the line
//	next.Hit(t, point, normal, "ball")                  // where it ends; not called if it hits nothing
//	next.Number("pdf", pdf); next.Color("weight", w)    // what else is known: see docs/rays.md
//
// Vectors are [3]float64, or a type of it. In pixels that are not chosen all rays are nil: a call tests that.
package rays

import (
	"encoding/json"
	"fmt"
	"os"
	"regexp"
	"strings"
	"sync/atomic"
)

var chosen, file = open() // blocks of pixels (nothing, width, height, x, y, step), and the log

func open() (chosen [][6]int, out *os.File) {
	pattern := regexp.MustCompile(`^(?:(?:(\d+)x(\d+)\+)?(\d+)[,+](\d+)|/(0*[1-9]\d*))$`)
	for _, item := range strings.Fields(strings.ReplaceAll(os.Getenv("RAYS"), ";", " ")) {
		block := [6]int{1: 1, 2: 1, 5: 1}
		found := pattern.FindStringSubmatch(item)
		if found == nil {
			fmt.Fprintln(os.Stderr, "rays: RAYS is x,y or WxH+X+Y or /N, or several with ';', not", item)
			return nil, nil
		}
		if found[5] != "" {
			block[1], block[2] = 1<<30, 1<<30
		}
		for i := range block {
			fmt.Sscan(found[i], &block[i])
		}
		chosen = append(chosen, block)
	}
	name, isNamed := os.LookupEnv("RAYS_FILE")
	if !isNamed {
		name = "rays.jsonl"
	}
	if len(chosen) == 0 {
		return nil, nil
	}
	out, err := os.Create(name)
	if err != nil {
		fmt.Fprintln(os.Stderr, "rays:", err)
	}
	fmt.Fprintln(out, `{"rays": 1}`)
	return chosen, out
}

// Line writes a line of its own: {"object": "ball", "sphere": {"center": [0, 1, 0], "radius": 1}} or {"lamp": "sun", …}.
func Line(json string) { fmt.Fprintln(file, json) }

// Ray is a ray whose line is being written; that of Pixel is the parent of the camera's, and has no line.
type Ray struct {
	pixel, line string
	count       *int64 // of the rays of the sample
	own         int64
}

func Pixel(x, y, sample int) *Ray {
	is := func(at, length, step int) bool { return at >= 0 && at < length && at%step == 0 }
	for _, b := range chosen {
		if file != nil && is(x-b[3], b[1], b[5]) && is(y-b[4], b[2], b[5]) {
			return &Ray{fmt.Sprintf(`{"pixel": [%d, %d], "sample": %d`, x, y, sample), "", new(int64), -1}
		}
	}
	return nil
}

func (r *Ray) Ray(kind string, origin, direction [3]float64) *Ray {
	if r == nil {
		return nil
	}
	ray := &Ray{r.pixel, r.pixel, r.count, atomic.AddInt64(r.count, 1) - 1}
	put(ray, "ray", ray.own)
	if r.own >= 0 {
		put(ray, "parent", r.own)
	}
	ray.Text("kind", kind)
	ray.Color("origin", origin)
	ray.Color("direction", direction)
	return ray
}

func put[T any](r *Ray, field string, value T) {
	if r != nil {
		r.line += fmt.Sprintf(", %q: %v", field, value)
	}
}
func (r *Ray) Number(field string, x float64)   { put(r, field, x) }
func (r *Ray) Flag(field string, x bool)        { put(r, field, x) }
func (r *Ray) Color(field string, v [3]float64) { put(r, field, list(v)) }
func (r *Ray) Text(field, value string)         { put(r, field, text(value)) }
func (r *Ray) Hit(t float64, point, normal [3]float64, object string) {
	r.Number("t", t)
	r.Color("point", point)
	r.Color("normal", normal)
	r.Text("object", object)
}
func (r *Ray) End() {
	if r != nil {
		Line(r.line + "}")
	}
}

type list [3]float64
type text string

func (v list) String() string { return fmt.Sprintf("[%v, %v, %v]", v[0], v[1], v[2]) }
func (t text) String() string { json, _ := json.Marshal(string(t)); return string(json) }
