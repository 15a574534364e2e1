// Writes down the rays of chosen pixels, one JSON object a line, for `groundtruth rays` (docs/rays.md). Node and browsers.
//   RAYS=120,80 node tracer.js    writes rays.jsonl: the rays of that pixel; RAYS="120,80;121,80" of two,
//                                 RAYS=10x10+120+80 of a block, RAYS=/16 of each 16th column and row
//   RAYS_FILE=other.jsonl         to another file
//   page.html?RAYS=120,80         in a browser, or globalThis.RAYS = "120,80" before; then rays.download()
//
//   require("./rays.js"), import "./rays.js" or <script src="rays.js"> makes the global `rays`:
//   rays.pixel(x, y, sample);                                  // before the camera's ray of a sample
//   const log = rays.ray("reflected", origin, direction);      // where a ray begins: camera, reflected, transmitted,
//                                                              // diffuse, path, shadow; a child of the one that is open
//   log.hit(t, point, normal, "ball");                         // where it ends; not called if it hits nothing
//   log.number("pdf", pdf); log.color("weight", w);            // what else is known: see docs/rays.md
//   log.end();                                                 // before each `return`: writes the line
// Vectors are arrays or have .x, .y, .z. Without RAYS a call tests a bool.
(() => {
    "use strict";
    const isNode = typeof process === "object" && !!(process.versions && process.versions.node);
    const node = (name) => (typeof require === "function" ? require(name) : process.getBuiltinModule(name));
    const browser = () => typeof location === "object" && new URLSearchParams(location.search).get("RAYS");
    const chosen = choose(globalThis.RAYS || (isNode ? process.env.RAYS : browser()) || "");
    const lines = [];
    let file = null;
    let on = false;                 // whether the program is in a chosen pixel
    let [x, y, sample, next, open] = [0, 0, 0, 0, null];    // open: the number of the ray around the next one

    function choose(text) {
        const items = text.split(";").filter((item) => item.trim());
        const pattern = /^\s*(?:(\d+),(\d+)|(\d+)x(\d+)\+(\d+)\+(\d+)|\/(0*[1-9]\d*))\s*$/;
        const wrong = items.find((item) => !pattern.test(item));
        if (wrong) console.error(`rays: RAYS is x,y or WxH+X+Y or /N, or several with ';', not ${wrong}`);
        return wrong ? [] : items.map((item) => {
            const [px, py, width, height, left, top, step] = pattern.exec(item).slice(1).map((n) => (n ? Number(n) : null));
            if (step) return [0, 0, Infinity, Infinity, step];
            return px === null ? [left, top, width, height, 1] : [px, py, 1, 1, 1];
        });
    }

    function start() {
        if (isNode) {
            // a worker thread writes into the file of the main one
            const fs = node("fs"), name = process.env.RAYS_FILE || "rays.jsonl";
            if (node("worker_threads").isMainThread) fs.writeFileSync(name, '{"rays": 1}\n');
            const out = fs.openSync(name, "a");
            file = (line) => fs.writeSync(out, line + "\n");
        } else {
            file = (line) => lines.push(line);
            file('{"rays": 1}');
        }
    }

    const json = (v) => {
        if (typeof v === "number") return Number.isFinite(v) ? String(v) : `"${v}"`;
        return `[${(v.x === undefined ? Array.from(v) : [v.x, v.y, v.z]).map(json).join(", ")}]`;
    };

    class Nothing {
        number() {}
        color() {}
        flag() {}
        text() {}
        hit() {}
        end() {}
    }

    class Ray {
        constructor(kind, origin, direction) {
            [this.own, this.before] = [next, open];
            open = next++;
            this.line = `{"pixel": [${x}, ${y}], "sample": ${sample}, "ray": ${this.own}`;
            if (this.before !== null) this.put("parent", this.before);
            this.text("kind", kind);
            this.color("origin", origin);
            this.color("direction", direction);
        }
        put(field, value) { this.line += `, "${field}": ${value}`; }
        number(field, value) { this.put(field, json(Number(value))); }
        color(field, value) { this.put(field, json(value)); }
        flag(field, value) { this.put(field, Boolean(value)); }
        text(field, value) { this.put(field, JSON.stringify(String(value))); }
        hit(t, point, normal, object) {
            this.number("t", t);
            this.color("point", point);
            this.color("normal", normal);
            if (object !== undefined) this.text("object", object);
        }
        end() {
            if (open >= this.own) open = this.before;
            file(this.line + "}");
        }
    }

    const nothing = new Nothing();
    try {
        if (chosen.length) start();
    } catch (error) {
        console.error(`rays: ${error.message}`);
    }
    const rays = {
        lines,          // in a browser; a web worker posts its own to the page, which pushes them here
        // a line of its own: {object: "ball", sphere: {center: [0, 1, 0], radius: 1}} or {lamp: "sun", ...}
        line(value) { if (file) file(typeof value === "string" ? value : JSON.stringify(value)); },
        pixel(column, row, number = 0) {
            if (!file) return;
            [x, y, sample, next, open] = [column, row, number, 0, null];
            on = chosen.some(([left, top, width, height, step]) => x >= left && y >= top && x - left < width &&
                y - top < height && (x - left) % step === 0 && (y - top) % step === 0);
        },
        ray(kind, origin, direction) { return on ? new Ray(kind, origin, direction) : nothing; },
        download(name = "rays.jsonl") {
            const url = URL.createObjectURL(new Blob([lines.join("\n") + "\n"], { type: "application/jsonl" }));
            Object.assign(document.createElement("a"), { href: url, download: name }).click();
            setTimeout(() => URL.revokeObjectURL(url), 1000);
        },
    };
    globalThis.rays = rays;
    if (typeof module === "object" && module.exports) module.exports = rays;
})();
