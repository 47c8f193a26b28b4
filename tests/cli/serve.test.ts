import { request } from 'node:http';
import { expect, test } from 'vitest';
import { programResult, start } from './program.ts';

interface Answer {
  readonly status: number | undefined;
  readonly headers: NodeJS.Dict<string | string[]>;
  readonly body: string;
}

/** A raw request, as a careless or hostile client would send it; `fetch` would normalize the path first. */
function get(url: string, path: string, headers: Record<string, string> = {}): Promise<Answer> {
  return new Promise((resolve, reject) => {
    const { hostname, port } = new URL(url);
    request({ hostname, port, path, headers }, (response) => {
      let body = '';
      response.on('data', (chunk) => (body += chunk));
      response.on('end', () => resolve({ status: response.statusCode, headers: response.headers, body }));
    })
      .on('error', reject)
      .end();
  });
}

test('serves only the page and its scenes, and only to this machine', async () => {
  const child = start('serve', '--port', '0', '--json');
  const ended = programResult(child);
  const url = await new Promise<string>((resolve) =>
    child.stdout?.once('data', (line: Buffer) => resolve((JSON.parse(line.toString()) as { url: string }).url)),
  );
  expect(url).toMatch(/^http:\/\/127\.0\.0\.1:\d+$/);

  const page = await get(url, '/');
  expect(page.status).toBe(200);
  expect(page.headers['content-type']).toContain('text/html');
  expect(page.headers['content-security-policy']).toMatch(/script-src 'self';/);
  const script = /src="\.\/(assets\/[^"]+\.js)"/.exec(page.body)?.[1];
  expect((await get(url, `/${script}`)).headers['content-type']).toContain('text/javascript');

  const scenes = await get(url, '/examples/index.json');
  expect(scenes.headers['content-type']).toContain('json');
  for (const { source } of JSON.parse(scenes.body) as { source: string }[]) {
    expect((await get(url, `/${source}`)).status).toBe(200);
  }

  expect((await get(url, '/api')).headers.location).toBe('/api/');
  const api = await get(url, '/api/');
  expect(api.status).toBe(200);
  // Nothing in these pages is forbidden by the content policy, or comes from elsewhere.
  expect(api.body).not.toMatch(/<script>|(?:src|href)="https?:/);
  const gamma = await get(
    url,
    `/api/${/functions\/[^"]*physics\.gamma\.html/.exec((await get(url, '/api/modules/slowlight_physics.html')).body)![0]}`,
  );
  expect(gamma.body).toContain('1.6667');
  expect((await get(url, '/api/assets/main.js')).headers['cache-control']).toBe('no-cache');

  for (const path of [
    '/api/../../package.json',
    '/api/%2e%2e/%2e%2e/package.json',
    '/../../package.json',
    '/%2e%2e/%2e%2e/package.json',
    '/..%2f..%2fpackage.json',
    '/nothing',
  ]) {
    expect((await get(url, path)).status, path).toBe(404);
  }
  expect((await get(url, '/%ff')).status).toBe(400);
  expect((await get(url, '/', { host: 'elsewhere.example' })).status).toBe(403);

  child.kill('SIGINT');
  expect((await ended).code).toBe(0);
});
