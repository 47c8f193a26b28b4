/** One scene or project of the gallery, as `examples/index.json` lists it; made when the page is built, from their own words. */
export interface Example {
  /** Beside the page: `examples/street.usda`. */
  readonly source: string;
  /** `street` */
  readonly name: string;
  readonly title: string;
  readonly lookFor: string;
  /** Address of a picture of it. */
  readonly thumbnail?: string;
}

export async function loadExamples(): Promise<readonly Example[]> {
  const response = await fetch(new URL('examples/index.json', document.baseURI));
  if (!response.ok) throw new Error(`examples/index.json: the server answers ${response.status}`);
  return response.json() as Promise<readonly Example[]>;
}
