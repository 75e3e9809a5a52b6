import { createServer } from "node:http";
import type { AddressInfo } from "node:net";

import { Engine, type Fetch, HttpTransport } from "@oncard/engine";
import { expect, onTestFinished, test } from "vitest";

const page = "http://127.0.0.1:1/token/?engine=here";

interface Asked {
  method: string;
  address: string;
  body: string;
}

/** Answers as a test says, and keeps what was asked. */
function scripted(answer: (asked: Asked) => string | Promise<string>): {
  asked: Asked[];
  fetch: Fetch;
} {
  const asked: Asked[] = [];
  const fetch: Fetch = async (address, { method, body = "" }) => {
    const one = { method, address: address.href, body };
    asked.push(one);
    const text = one.address.endsWith("/sessions")
      ? '{"ok":true,"session":7}\n'
      : await answer(one);
    return { ok: true, status: 200, text: () => Promise.resolve(text) };
  };
  return { asked, fetch };
}

const echo = ({ body }: Asked) => {
  const { id, request } = JSON.parse(body) as { id: number; request: string };
  return `${JSON.stringify({ id, ok: true, result: request })}\n`;
};

test("requests go to a session of their own beside the page", async () => {
  const { asked, fetch } = scripted(echo);
  const engine = new Engine(new HttpTransport(page, fetch));
  expect(await engine.state()).toBe("state");
  expect(asked.map(({ method, address }) => `${method} ${address}`)).toEqual([
    "POST http://127.0.0.1:1/token/sessions",
    "POST http://127.0.0.1:1/token/sessions/7",
  ]);
  expect(JSON.parse(asked[1]?.body ?? "")).toEqual({ id: 1, request: "state", arguments: {} });
});

test("a request is sent when the one before it has been answered", async () => {
  let release: () => void = () => undefined;
  const first = new Promise<void>((resolve) => {
    release = resolve;
  });
  const { asked, fetch } = scripted(async (one) => {
    if (one.body.includes('"state"')) await first;
    return echo(one);
  });
  const engine = new Engine(new HttpTransport(page, fetch));
  const answers: unknown[] = [];
  const both = [engine.state(), engine.card()].map((each) => each.then((is) => answers.push(is)));
  await new Promise((resume) => setTimeout(resume));
  expect(asked.map(({ body }) => body).filter((body) => body.includes("card"))).toEqual([]);
  release();
  await Promise.all(both);
  expect(answers).toEqual(["state", "card"]);
});

test("events come before their answer", async () => {
  const event = JSON.stringify({ event: "log", moment: 1, thread: 0, text: "x is 5" });
  const { fetch } = scripted((one) => `${event}\n${echo(one)}`);
  const engine = new Engine(new HttpTransport(page, fetch));
  const log: string[] = [];
  engine.onLog = ({ text }) => log.push(text);
  await engine.state();
  expect(log).toEqual(["x is 5"]);
});

test("a server that is gone ends the engine, and the message keeps the secret", async () => {
  const { fetch } = scripted(() => Promise.reject(new TypeError("Failed to fetch")));
  const engine = new Engine(new HttpTransport(page, fetch));
  const ended: string[] = [];
  engine.onEnded = ({ message }) => ended.push(message);
  await expect(engine.state()).rejects.toThrow(
    "oncard serve does not answer any more at 127.0.0.1:1",
  );
  await expect(engine.card()).rejects.toThrow("does not answer any more");
  expect(ended).toEqual(["oncard serve does not answer any more at 127.0.0.1:1"]);
});

test("a server without a session for the page ends the engine with its reason", async () => {
  const refused = '{"id":null,"ok":false,"error":"there are already 16 sessions"}\n';
  const fetch: Fetch = () =>
    Promise.resolve({ ok: false, status: 503, text: () => Promise.resolve(refused) });
  const engine = new Engine(new HttpTransport(page, fetch));
  await expect(engine.state()).rejects.toThrow("there are already 16 sessions");
});

test("a refusal without a reason is told with its number", async () => {
  const fetch: Fetch = () =>
    Promise.resolve({ ok: false, status: 413, text: () => Promise.resolve("") });
  const engine = new Engine(new HttpTransport(page, fetch));
  await expect(engine.state()).rejects.toThrow("refuses a request with 413");
});

test("closing ends the session, also one that begins", async () => {
  const { asked, fetch } = scripted(echo);
  const engine = new Engine(new HttpTransport(page, fetch));
  engine.close();
  engine.close();
  await new Promise((resume) => setTimeout(resume));
  expect(asked.map(({ method, address }) => `${method} ${address}`)).toEqual([
    "POST http://127.0.0.1:1/token/sessions",
    "DELETE http://127.0.0.1:1/token/sessions/7",
  ]);
});

test("without another fetch, it is that of this place", async () => {
  const server = createServer((request, response) => {
    request.resume().on("end", () => {
      response.end(
        request.url === "/token/sessions"
          ? '{"ok":true,"session":1}\n'
          : '{"id":1,"ok":true,"result":"over HTTP"}\n',
      );
    });
  });
  await new Promise<void>((started) => server.listen(0, "127.0.0.1", started));
  onTestFinished(() => {
    server.close();
  });
  const { port } = server.address() as AddressInfo;
  const engine = new Engine(new HttpTransport(`http://127.0.0.1:${port}/token/`));
  expect(await engine.state()).toBe("over HTTP");
});
