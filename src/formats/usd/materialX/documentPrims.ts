import { type Message, msg } from '../../../messages/message.ts';
import { inputError } from '../../diagnostics/inputError.ts';
import { type AttributeSpec, EMPTY_MAP, type PrimSpec, type PropertySpec } from '../layer/layer.ts';
import { attribute, connected, primSpec, uniform } from '../layer/specs.ts';
import type { DocumentElement } from './documents.ts';
import { nodeId } from './nodeIds.ts';
import { parseMaterialXValue, usdName, usdTypeOf } from './values.ts';
import type { XmlElement } from './xml.ts';

/** Told of what is left out of a document. */
export type MaterialXRemark = (code: 'mtlx.value' | 'mtlx.left-out', message: Message) => void;

/** Maximum number of prims of a layer: every material has its own copy of its graphs. */
export const MAX_MATERIALX_PRIMS = 50_000;
/** Maximum depth of custom nodes that are made of custom nodes. */
const MAX_CUSTOM_DEPTH = 16;

export const emptyPrim = (path: string, type: string): PrimSpec => primSpec(path, { type, properties: [] });

/** Elements that are neither nodes nor graphs. */
const NO_NODES =
  /^(input|output|token|nodegraph|nodedef|implementation|typedef|geominfo|geompropdef|look|lookgroup|collection|propertyset|variantset|variant|unitdef|unittypedef|targetdef|attributedef|backdrop|material|surfacematerial|volumematerial|comment)$/;

/** What holds around an element, nearest first. */
interface Surroundings {
  readonly colorSpace: string;
  readonly filePrefix: string;
  readonly file: string;
}

/** Where names of nodes lead. */
interface NameScope {
  /** Path of the prim that holds the nodes. */
  readonly nodes: string;
  /** Path of the prim with the interface inputs; undefined outside node graphs. */
  readonly interface: string | undefined;
  /** Path of the prim that holds the node graphs; those that are named are `wanted`. */
  readonly graphs: string;
  readonly wanted: Wanted;
  readonly depth: number;
}

/** What a material has yet to hold. */
interface Wanted {
  readonly graphs: Set<string>;
  /** Nodes outside graphs. */
  readonly nodes: Set<string>;
}

interface CustomNode {
  readonly definition: XmlElement;
  readonly graph: XmlElement;
  readonly around: Surroundings;
}

/** Makes the prims of a document. */
export class DocumentPrims {
  private readonly elements: readonly DocumentElement[];
  private readonly file: string;
  private readonly remark: MaterialXRemark;
  private readonly byName = new Map<string, DocumentElement>();
  private readonly custom = new Map<string, CustomNode>();
  private prims = 0;

  constructor(elements: readonly DocumentElement[], file: string, remark: MaterialXRemark) {
    this.elements = elements;
    this.file = file;
    this.remark = remark;
    for (const at of elements) {
      const name = at.element.attributes.get('name');
      if (name !== undefined && !this.byName.has(name)) this.byName.set(name, at);
    }
    for (const at of elements) this.addCustomNode(at);
  }

  /** A nodedef of the document whose implementation is a node graph. */
  private addCustomNode({ element, ...around }: DocumentElement): void {
    const definition = this.byName.get(element.attributes.get('nodedef') ?? '')?.element;
    if (element.name !== 'nodegraph' || definition?.name !== 'nodedef') return;
    this.custom.set(definition.attributes.get('node') ?? '', { definition, graph: element, around });
  }

  materials(): ReadonlyMap<string, PrimSpec> {
    return this.named(
      ({ name }) => name === 'surfacematerial',
      (at, name) => this.material(at, `/MaterialX/Materials/${name}`),
    );
  }

  nodeGraphs(): ReadonlyMap<string, PrimSpec> {
    return this.named(
      ({ name, attributes }) => name === 'nodegraph' && !attributes.has('nodedef'),
      (at, name) => this.nodeGraph(at, `/MaterialX/NodeGraphs/${name}`, '/MaterialX/NodeGraphs', newWanted()),
    );
  }

  shaders(): ReadonlyMap<string, PrimSpec> {
    const found = new Map<string, PrimSpec>();
    for (const { element } of this.elements) {
      if (element.attributes.get('type') !== 'surfaceshader' || NO_NODES.test(element.name)) continue;
      const id = nodeId(element);
      const name = usdName(id);
      found.set(name, {
        ...this.counted(emptyPrim(`/MaterialX/Shaders/${name}`, 'Shader'), element),
        properties: propertiesOf([idOf(id), output('surface', 'token')]),
      });
    }
    return found;
  }

  private named(
    isWanted: (element: XmlElement) => boolean,
    make: (at: DocumentElement, name: string) => PrimSpec,
  ): ReadonlyMap<string, PrimSpec> {
    const found = new Map<string, PrimSpec>();
    for (const at of this.elements) {
      const { attributes } = at.element;
      const name = usdName(attributes.get('name') ?? '');
      if (isWanted(at.element) && attributes.has('name') && !found.has(name)) found.set(name, make(at, name));
    }
    return found;
  }

  private counted(prim: PrimSpec, { line }: XmlElement): PrimSpec {
    if (++this.prims > MAX_MATERIALX_PRIMS)
      throw inputError(
        'mtlx.too-large',
        this.file,
        msg`line ${line}: its materials and graphs make more than ${MAX_MATERIALX_PRIMS} prims`,
      );
    return prim;
  }

  /** A material: its shader, and below it the graphs and nodes that drive it. */
  private material(at: DocumentElement, path: string): PrimSpec {
    const prim = this.counted(emptyPrim(path, 'Material'), at.element);
    const children = new Map<string, PrimSpec>();
    const properties: PropertySpec[] = [];
    const wanted = newWanted();
    for (const [input, output] of [
      ['surfaceshader', 'surface'],
      ['displacementshader', 'displacement'],
    ]) {
      const source = inputsOf(at.element).find(({ attributes }) => attributes.get('name') === input);
      if (!source || !(source.attributes.get('nodename') || source.attributes.get('nodegraph'))) continue;
      const target = this.shaderOf(source, at, path, wanted, children, properties);
      if (target) properties.push(connected('token', `outputs:mtlx:${output}`, target));
    }
    this.addWanted(path, wanted, children);
    return { ...prim, children, properties: propertiesOf(properties) };
  }

  /** Adds the shader that an input of a material names; the path of its output. */
  private shaderOf(
    source: XmlElement,
    at: DocumentElement,
    path: string,
    wanted: Wanted,
    children: Map<string, PrimSpec>,
    properties: PropertySpec[],
  ): string | undefined {
    const { attributes, line } = source;
    const graph = attributes.get('nodegraph');
    if (graph !== undefined) {
      wanted.graphs.add(graph);
      return `${path}/${usdName(graph)}.outputs:${usdName(attributes.get('output') ?? 'out')}`;
    }
    const shader = this.byName.get(attributes.get('nodename') ?? '');
    if (!shader || NO_NODES.test(shader.element.name)) {
      this.remark(
        'mtlx.left-out',
        msg`line ${line}: <surfacematerial> '${at.element.attributes.get('name') ?? ''}' names the shader '${attributes.get('nodename') ?? ''}', which is not there`,
      );
      return undefined;
    }
    const id = usdName(nodeId(shader.element));
    const scope = { nodes: `${path}/NodeGraphs`, interface: undefined, graphs: path, wanted, depth: 0 };
    const custom = this.custom.get(shader.element.name);
    const made = custom
      ? this.customNode(custom, shader.element, `${path}/${id}`, scope, shader)
      : this.node(shader.element, `${path}/${id}`, scope, shader);
    // Values are inputs of the material, so that layers above can change them there.
    const inputs = new Map(made.properties);
    for (const [name, property] of inputs) {
      if (property.kind !== 'attribute' || property.value === undefined || property.connections) continue;
      if (!name.startsWith('inputs:') || properties.some((other) => other.name === name)) continue;
      const { value: _, metadata: __, ...declared } = property;
      properties.push(property);
      inputs.set(name, { ...declared, metadata: EMPTY_MAP, connections: to(`${path}.${name}`) });
    }
    children.set(id, { ...made, properties: inputs });
    return `${path}/${id}.outputs:${custom ? 'out' : 'surface'}`;
  }

  /** The graphs and nodes that were named, and those that they name in turn. */
  private addWanted(path: string, wanted: Wanted, children: Map<string, PrimSpec>): void {
    const nodes = new Map<string, PrimSpec>();
    const scope = { nodes: `${path}/NodeGraphs`, interface: undefined, graphs: path, wanted, depth: 0 };
    // Both sets grow while they are gone through.
    for (let before = -1; before !== wanted.graphs.size + wanted.nodes.size; ) {
      before = wanted.graphs.size + wanted.nodes.size;
      for (const name of wanted.graphs) {
        const at = this.byName.get(name);
        if (at?.element.name !== 'nodegraph' || children.has(usdName(name))) continue;
        children.set(usdName(name), this.nodeGraph(at, `${path}/${usdName(name)}`, path, wanted));
      }
      for (const name of wanted.nodes) {
        const at = this.byName.get(name);
        if (!at || NO_NODES.test(at.element.name) || nodes.has(usdName(name))) continue;
        this.addNode(nodes, at.element, scope, at);
      }
    }
    if (nodes.size > 0) children.set('NodeGraphs', { ...emptyPrim(`${path}/NodeGraphs`, ''), children: nodes });
  }

  private nodeGraph(at: DocumentElement, path: string, graphs: string, wanted: Wanted): PrimSpec {
    const scope = { nodes: path, interface: path, graphs, wanted, depth: 0 };
    return this.graph(at.element, path, scope, inputsOf(at.element), around(at.element, at));
  }

  /** A NodeGraph with the nodes of `element`, and `inputs` as its interface. */
  private graph(
    element: XmlElement,
    path: string,
    scope: NameScope,
    inputs: readonly XmlElement[],
    where: Surroundings,
    outer?: NameScope,
  ): PrimSpec {
    const children = new Map<string, PrimSpec>();
    for (const node of element.children)
      if (!NO_NODES.test(node.name)) this.addNode(children, node, scope, around(node, where));
    const properties = inputs.map((input) =>
      this.input(input, element, outer ?? { ...scope, interface: undefined }, where),
    );
    for (const port of element.children) {
      if (port.name !== 'output') continue;
      const target = this.targetOf(port, scope);
      const made = output(
        usdName(port.attributes.get('name') ?? 'out'),
        usdTypeOf(port.attributes.get('type') ?? '').typeName,
      );
      properties.push(target ? { ...made, connections: to(target) } : made);
    }
    return { ...this.counted(emptyPrim(path, 'NodeGraph'), element), children, properties: propertiesOf(properties) };
  }

  private addNode(into: Map<string, PrimSpec>, element: XmlElement, scope: NameScope, where: Surroundings): void {
    const name = usdName(element.attributes.get('name') ?? element.name);
    if (into.has(name)) return;
    const path = `${scope.nodes}/${name}`;
    const custom = this.custom.get(element.name);
    into.set(
      name,
      custom ? this.customNode(custom, element, path, scope, where) : this.node(element, path, scope, where),
    );
    for (const input of inputsOf(element)) {
      const channels = input.attributes.get('channels');
      const target = channels === undefined ? undefined : this.targetOf(input, scope);
      if (target === undefined) continue;
      const type = input.attributes.get('type') ?? '';
      const between = channelsName(name, input);
      into.set(between, {
        ...this.counted(emptyPrim(`${scope.nodes}/${between}`, 'Shader'), input),
        properties: propertiesOf([
          idOf(`ND_swizzle_${type}`),
          connected('float4', 'inputs:in', target),
          attribute('string', 'inputs:channels', { type: 'string', data: channels! }),
          output('out', usdTypeOf(type).typeName),
        ]),
      });
    }
  }

  /** A node of a definition of the document: its graph, with the definition's inputs as the node sets them. */
  private customNode(
    { definition, graph, around: within }: CustomNode,
    element: XmlElement,
    path: string,
    scope: NameScope,
    where: Surroundings,
  ): PrimSpec {
    if (scope.depth >= MAX_CUSTOM_DEPTH)
      throw inputError(
        'mtlx.too-large',
        this.file,
        msg`line ${element.line}: its own nodes are nested more than ${MAX_CUSTOM_DEPTH} deep`,
      );
    const own = new Map(inputsOf(element).map((input) => [input.attributes.get('name'), input]));
    const inputs = inputsOf(definition).map((input) => own.get(input.attributes.get('name')) ?? input);
    const inside = { ...scope, nodes: path, interface: path, depth: scope.depth + 1 };
    return this.graph(graph, path, inside, inputs, { ...within, file: where.file }, scope);
  }

  private node(element: XmlElement, path: string, scope: NameScope, where: Surroundings): PrimSpec {
    const type = element.attributes.get('type') ?? '';
    const inputs = inputsOf(element).map((input) => this.input(input, element, scope, around(element, where)));
    const outputs =
      type === 'surfaceshader'
        ? [output('surface', 'token'), output('out', 'token')]
        : [output('out', usdTypeOf(type).typeName)];
    return {
      ...this.counted(emptyPrim(path, 'Shader'), element),
      properties: propertiesOf([idOf(nodeId(element)), ...inputs, ...outputs]),
    };
  }

  /** An input with its value or connection. */
  private input(element: XmlElement, node: XmlElement, scope: NameScope, where: Surroundings): AttributeSpec {
    const { attributes, line } = element;
    const [name, type] = [attributes.get('name') ?? '', attributes.get('type') ?? ''];
    const made = attribute(usdTypeOf(type).typeName, `inputs:${usdName(name)}`);
    const target =
      attributes.has('channels') && this.targetOf(element, scope)
        ? `${scope.nodes}/${channelsName(usdName(node.attributes.get('name') ?? ''), element)}.outputs:out`
        : this.targetOf(element, scope);
    if (target) made.connections = to(target);
    const text = attributes.get('value');
    if (text === undefined || (text === '' && type !== 'string')) return made;
    const prefix = type === 'filename' ? where.filePrefix : '';
    made.value = parseMaterialXValue(type, prefix + text);
    if (made.value === undefined)
      this.remark(
        'mtlx.value',
        msg`${where.file}, line ${line}: the input '${name}' of <${node.name}> '${node.attributes.get('name') ?? ''}' has the value '${text}', which is no ${type}; it is left out`,
      );
    const colorSpace = attributes.get('colorspace') ?? where.colorSpace;
    const isColorFile = type === 'filename' && /^color[34]$/.test(node.attributes.get('type') ?? '');
    if (/^color[34]$/.test(type) ? colorSpace !== '' : isColorFile)
      made.metadata = new Map([['colorSpace', { type: 'token', data: colorSpace || 'lin_rec709' } as const]]);
    return made;
  }

  /** The path of the output, or of the interface input, that an input or output is connected to. */
  private targetOf({ attributes }: XmlElement, scope: NameScope): string | undefined {
    const port = usdName(attributes.get('output') ?? 'out');
    const [name, node, graph] = ['interfacename', 'nodename', 'nodegraph'].map((key) => attributes.get(key));
    if (name !== undefined && scope.interface !== undefined) return `${scope.interface}.inputs:${usdName(name)}`;
    if (graph !== undefined) {
      scope.wanted.graphs.add(graph);
      return `${scope.graphs}/${usdName(graph)}.outputs:${port}`;
    }
    if (node !== undefined) {
      if (scope.interface === undefined) scope.wanted.nodes.add(node);
      return `${scope.nodes}/${usdName(node)}.outputs:${port}`;
    }
    // An output of the document, which names a node.
    const outside =
      scope.interface === undefined ? this.byName.get(attributes.get('output') ?? '')?.element : undefined;
    return outside?.name === 'output' ? this.targetOf(outside, scope) : undefined;
  }
}

const newWanted = (): Wanted => ({ graphs: new Set(), nodes: new Set() });

const inputsOf = ({ children }: XmlElement): XmlElement[] => children.filter(({ name }) => name === 'input');

const channelsName = (node: string, { attributes }: XmlElement): string =>
  `${node}_${usdName(attributes.get('name') ?? '')}_channels`;

const around = ({ attributes }: XmlElement, outside: Surroundings): Surroundings => ({
  file: outside.file,
  colorSpace: attributes.get('colorspace') ?? outside.colorSpace,
  filePrefix: attributes.get('fileprefix') ?? outside.filePrefix,
});

const output = (name: string, typeName: string): AttributeSpec => attribute(typeName, `outputs:${name}`);

const idOf = (id: string): AttributeSpec => uniform('token', 'info:id', { type: 'token', data: id });

const to = (path: string) => ({ explicit: [path] });

const propertiesOf = (properties: readonly PropertySpec[]): ReadonlyMap<string, PropertySpec> =>
  new Map(properties.map((property) => [property.name, property]));
