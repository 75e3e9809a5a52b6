// Hands out a folder on this computer alone, until Ctrl-C.
//   node tools/serve.js FOLDER [PORT] [PATH]
// Without a port, one that is free. PATH is where the folder appears, `/` without it.

import { createServer } from "node:http";
import { resolve } from "node:path";

import sirv from "sirv";

const [folder = ".", port = "0", path = "/"] = process.argv.slice(2);
const files = sirv(resolve(folder), { dev: true });
const server = createServer((request, response) => {
  const notFound = () => {
    response.writeHead(404).end("not found\n");
  };
  if (!request.url?.startsWith(path)) {
    notFound();
    return;
  }
  request.url = `/${request.url.slice(path.length)}`;
  files(request, response, notFound);
});
server.listen(Number(port), "127.0.0.1", () => {
  console.log(`http://127.0.0.1:${server.address().port}${path}`);
});
