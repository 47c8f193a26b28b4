export interface SimulateFlags {
  readonly output?: string;
  readonly csv?: string;
  readonly node?: string;
  readonly checkpoint?: string;
  readonly resume?: boolean;
  readonly set?: readonly string[];
  readonly json?: boolean;
}
