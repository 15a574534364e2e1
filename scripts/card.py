#!/usr/bin/env python3
"""Prints a card of `groundtruth conform --json` as Markdown: a table question and kind × status, and what failed.

Run: python3 scripts/card.py TITLE card.json"""
import json
import sys

STATUSES = ["pass", "wrong", "refused", "unsupported", "hung", "died", "garbled", "undecided"]
title, file = sys.argv[1:]
with open(file) as text:
    card = json.load(text)

kinds = {}
unsupported = []
for row in card["families"]:
    key = (row["chapter"], ".".join(row["family"].split(".")[:2]))
    counts = kinds.setdefault(key, dict.fromkeys([*STATUSES, "fair"], 0))
    for status, n in [*row["counts"].items(), ("fair", row["fair"])]:
        counts[status] += n
answered = {key: counts for key, counts in kinds.items() if any(n for status, n in counts.items() if status != "unsupported")}
shown = [status for status in STATUSES if any(counts[status] for counts in answered.values())]
print(f"### {title}, seed {card['seed']}\n")
print("| chapter | question | " + " | ".join(shown) + " |\n| --- | --- |" + " --- |" * len(shown))
for (chapter, question), counts in answered.items():
    cells = [str(counts[status] or "·") for status in shown]
    if counts["fair"]:
        cells[shown.index("wrong")] += f" ({counts['fair']} fair)"
    print(f"| {chapter} | `{question}` | " + " | ".join(cells) + " |")
print(f"\n{len(answered)} of {len(kinds)} kinds of questions are answered.\n")
for row in card["families"]:
    for message in row["messages"]:
        if message["status"] != "unsupported":
            count = row["counts"][message["status"]]
            print(f"{row['family']}: {count} {message['status']}: {message['text']}\n  asked     {json.dumps(message['question'])}")
    if not row["failure"]:
        continue
    fair = f", {row['fair']} of them fair in single precision" if row["fair"] else ""
    print(f"{row['family']}: {row['counts']['wrong']} of {sum(row['counts'].values())} wrong{fair}")
    for name in row["names"]:
        print(f"  looks like: {name}")
    for pair in row["failure"]["asked"]:
        print(f"  asked     {json.dumps(pair['question'])}\n  got       {pair['answer']}")
    error = row["failure"]["error"]
    off = f" ({row['failure']['symptom']}" + (f": off by {error:.3e} u·cond)" if error is not None else ")")
    print(f"  expected  {row['failure']['expected']}{off}")
print()
