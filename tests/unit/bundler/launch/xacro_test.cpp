// Documents of xacro against what the tool itself makes of them.
#include "bundler/launch/xacro/xacro.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/bundler/support/xacro_documents.hpp"
#include "workspace_schema/base/xml_reader.hpp"

namespace ros2wasm {
namespace {

using xacro_documents::expand;
using xacro_documents::robot;

std::string one_spaced(const std::string& text) {
  std::string result;
  for (const char c : text + " ") {
    const bool space = c == ' ' || c == '\n' || c == '\t';
    if (!space) result += c;
    if (space && !result.empty() && result.back() != ' ') result += ' ';
  }
  return result;
}

/// The tree, without white space that says nothing and with attributes in one order.
void write_tree(const XmlNode& node, std::string& into) {
  if (node.kind == XmlNodeKind::kComment) into += "(" + one_spaced(node.text) + ")";
  if (node.kind == XmlNodeKind::kText || node.kind == XmlNodeKind::kCdata)
    into += one_spaced(node.text);
  if (node.kind != XmlNodeKind::kElement) return;
  auto attributes = node.attributes;
  std::sort(attributes.begin(), attributes.end());
  into += "<" + node.text;
  for (const auto& [name, value] : attributes) into += " " + name + "=[" + one_spaced(value) + "]";
  into += ">";
  for (const XmlNode& child : node.children) write_tree(child, into);
  into += "</>";
}

std::string tree(const std::string& xml) {
  const auto root = parse_xml_nodes(xml, "x");
  EXPECT_TRUE(root.ok()) << xml;
  std::string result;
  if (root) write_tree(*root, result);
  return result;
}

struct Case {
  const char* what;
  const char* document;  ///< inside of the root element
  const char* result;    ///< likewise
};

constexpr Case kCases[] = {
    // Properties.
    {"a property", R"x(<xacro:property name="w" value="3"/><a b="${w}" c="x${w}y"/>)x",
     R"x(<a b="3" c="x3y"/>)x"},
    {"texts that are numbers or booleans become those",
     R"x(<xacro:property name="i" value=" 4 "/><xacro:property name="f" value="1.50"/>
        <xacro:property name="t" value="true"/><xacro:property name="s" value="1_0"/>
        <xacro:property name="z" value="007"/><a>${i+1} ${f*2} ${t} ${s} ${z}</a>)x",
     "<a>5 3.0 True 1_0 7</a>"},
    {"quotes keep a text a text until it is used",
     R"x(<xacro:property name="q" value="'a b'"/><xacro:macro name="m" params="p">${p + '!'}</xacro:macro>
        <a><xacro:m p="'12'"/> ${q}</a>)x",
     "<a>12! a b</a>"},
    {"definitions are evaluated when they are used",
     R"x(<xacro:property name="double" value="${2*single}"/><xacro:property name="single" value="21"/>
        <a b="${double}"/>)x",
     R"x(<a b="42"/>)x"},
    {"or where they stand",
     R"x(<xacro:property name="x" value="1"/><xacro:property name="y" value="${x}" lazy_eval="false"/>
        <xacro:property name="x" value="2"/><a>${y}${x}</a>)x",
     "<a>12</a>"},
    {"one may use its former self where it stands",
     R"x(<xacro:property name="n" value="1"/><xacro:property name="n" value="${n+1}" lazy_eval="false"/>
        ${n})x",
     "2"},
    {"a lone expression keeps its type, a text around it does not",
     R"x(<xacro:property name="l" value="${[1, 2.5, 'x']}"/><xacro:property name="t" value="${l} "/>
        <a b="${l[1]*2}" c="${t[0]}" d="${len(l)}"/>)x",
     R"x(<a b="5.0" c="[" d="3"/>)x"},
    {"a default is for who has no value",
     R"x(<xacro:property name="a" default="1"/><xacro:property name="a" default="2"/>
        <xacro:property name="b" value="3"/><xacro:property name="b" default="4"/>${a}${b})x",
     "13"},
    {"a property can be removed",
     R"x(<xacro:property name="a" value="1"/><xacro:property name="a" remove="true"/>
        <xacro:property name="a" default="7"/>${a})x",
     "7"},
    {"blocks",
     R"x(<xacro:property name="at"><origin xyz="${x} 0 0"/>text</xacro:property>
        <xacro:property name="x" value="5"/><a><xacro:insert_block name="at"/></a>
        <xacro:property name="x" value="6"/><b><xacro:insert_block name="at"/></b>)x",
     R"x(<a><origin xyz="5 0 0"/>text</a><b><origin xyz="6 0 0"/>text</b>)x"},
    {"the name of a property may be an expression",
     R"x(<xacro:property name="${'ab' + 'c'}" value="1"/>${abc})x", "1"},
    {"global names may be hidden",
     R"x(<xacro:property name="pi" value="3"/>${pi} ${math.pi} ${python.len('ab')})x",
     "3 3.141592653589793 2"},

    // Scopes.
    {"a macro has a scope of its own",
     R"x(<xacro:property name="p" value="out"/><xacro:macro name="m"><a p="${p}"/>
        <xacro:property name="p" value="in"/><b p="${p}"/></xacro:macro><xacro:m/><c p="${p}"/>)x",
     R"x(<a p="out"/><b p="in"/><c p="out"/>)x"},
    {"what it sees is what its caller sees",
     R"x(<xacro:macro name="inner"><a p="${p}"/></xacro:macro>
        <xacro:macro name="outer" params="p"><xacro:inner/></xacro:macro><xacro:outer p="7"/>)x",
     R"x(<a p="7"/>)x"},
    {"to the scope around it",
     R"x(<xacro:macro name="m" params="n"><xacro:property name="got" value="${n*2}" scope="parent"/>
        </xacro:macro><xacro:m n="4"/>${got})x",
     "8"},
    {"to the whole document",
     R"x(<xacro:macro name="m"><xacro:macro name="n"><xacro:property name="got" value="deep"
        scope="global"/></xacro:macro><xacro:n/></xacro:macro><xacro:m/>${got})x",
     "deep"},

    // Macros.
    {"parameters and defaults",
     R"x(<xacro:macro name="m" params="a b:=2 c='x y' d=${1 + 2} e:=z"><i a="${a}" b="${b}" c="${c}"
        d="${d}" e="${e}"/></xacro:macro><xacro:m a="1"/><xacro:m a="9" c="8" e=""/>)x",
     R"x(<i a="1" b="2" c="x y" d="3" e="z"/><i a="9" b="2" c="8" d="3" e=""/>)x"},
    {"parameters over many lines",
     "<xacro:macro name=\"m\" params=\"a\n   b:=3\n\tc\">${a}${b}${c}</xacro:macro>"
     "<xacro:m a=\"1\" c=\"2\"/>",
     "132"},
    {"forwarded from the caller",
     R"x(<xacro:property name="a" value="1"/><xacro:macro name="m" params="a:=^ b:=^|5 c:=^|">
        ${a}${b}</xacro:macro><xacro:property name="c" value="0"/><xacro:m/>
        <xacro:property name="b" value="6"/><xacro:m/>)x",
     "15 16"},
    {"values keep their types on the way in",
     R"x(<xacro:macro name="m" params="l d">${l[-1] + d['k']}</xacro:macro>
        <xacro:m l="${[1, 2]}" d="${dict(k=40)}"/>)x",
     "42"},
    {"defaults see what is around the call",
     R"x(<xacro:macro name="m" params="a b:=${a}"><xacro:property name="a" value="x"/>${b}</xacro:macro>
        <xacro:property name="a" value="1"/><xacro:m a="2"/>)x",
     "1"},
    {"a block",
     R"x(<xacro:macro name="m" params="name *at"><j n="${name}"><xacro:insert_block name="at"/>
        <again><xacro:insert_block name="at"/></again></j></xacro:macro>
        <xacro:m name="x"><!-- not kept --> nor this <origin rpy="0"/></xacro:m>)x",
     R"x(<j n="x"><origin rpy="0"/><again><origin rpy="0"/></again></j>)x"},
    {"blocks in their order, and what is in one",
     R"x(<xacro:macro name="m" params="*a **b"><x><xacro:insert_block name="b"/></x>
        <xacro:insert_block name="a"/></xacro:macro>
        <xacro:m><one k="1"/><two>t<three/></two></xacro:m>)x",
     R"x(<x>t<three/></x><one k="1"/>)x"},
    {"a block handed on",
     R"x(<xacro:macro name="in" params="*b"><i><xacro:insert_block name="b"/></i></xacro:macro>
        <xacro:macro name="out" params="*b"><o><xacro:in><xacro:insert_block name="b"/></xacro:in></o>
        </xacro:macro><xacro:out><leaf/></xacro:out>)x",
     "<o><i><leaf/></i></o>"},
    {"a macro in a macro",
     R"x(<xacro:macro name="m"><xacro:macro name="n"><deep/></xacro:macro><xacro:n/></xacro:macro>
        <xacro:m/>)x",
     "<deep/>"},
    {"a macro that is defined again",
     R"x(<xacro:macro name="m"><a/></xacro:macro><xacro:m/><xacro:macro name="m"><b/></xacro:macro>
        <xacro:m/>)x",
     "<a/><b/>"},
    {"a macro that calls itself",
     R"x(<xacro:macro name="m" params="n"><k n="${n}"/><xacro:if value="${n > 1}"><xacro:m n="${n-1}"/>
        </xacro:if></xacro:macro><xacro:m n="3"/>)x",
     R"x(<k n="3"/><k n="2"/><k n="1"/>)x"},
    {"a call by name",
     R"x(<xacro:macro name="left" params="n"><l n="${n}"/></xacro:macro><xacro:property name="w"
        value="left"/><xacro:call macro="${w}" n="2"/>)x",
     R"x(<l n="2"/>)x"},
    {"a name with the prefix", R"x(<xacro:macro name="xacro:m"><a/></xacro:macro><xacro:m/>)x",
     "<a/>"},
    {"a value is evaluated once",
     R"x(<xacro:macro name="m" params="a:=$${b}">${a}</xacro:macro><xacro:property name="c" value="$${b}"/>
        ${c} <xacro:m/>)x",
     "${b} ${b}"},

    // Conditions.
    {"if and unless",
     R"x(<xacro:if value="true"><a/></xacro:if><xacro:if value="0"><b/></xacro:if>
        <xacro:unless value="False"><c/></xacro:unless><xacro:unless value="${1 == 1}"><d/></xacro:unless>
        <xacro:if value="${0.1}"><e/></xacro:if><xacro:if value="${[]}"><f/></xacro:if>
        <xacro:if value="2"><g/></xacro:if>)x",
     "<a/><c/><e/><g/>"},
    {"what is not taken is not evaluated",
     R"x(<xacro:if value="false"><xacro:include filename="nowhere"/>${nothing}<xacro:none/></xacro:if>)x",
     ""},
    {"conditions in conditions, with texts",
     R"x(<a><xacro:if value="1">t <xacro:if value="1"><b/></xacro:if><xacro:unless value="1">x</xacro:unless>
        u</xacro:if></a>)x",
     "<a>t <b/> u</a>"},

    // Elements and attributes with names that are made.
    {"an element by name",
     R"x(<xacro:property name="kind" value="box"/><xacro:element xacro:name="${kind}" size="${1+1}">
        <in/></xacro:element>)x",
     R"x(<box size="2"><in/></box>)x"},
    {"an element by name may be a macro",
     R"x(<xacro:macro name="m" params="p"><a p="${p}"/></xacro:macro><xacro:element
        xacro:name="xacro:${'m'}" p="1"/>)x",
     R"x(<a p="1"/>)x"},
    {"an attribute by name",
     R"x(<a><xacro:attribute name="${'x' + 'y'}" value="${'1'}${2}"/><b/></a>)x",
     R"x(<a xy="12"><b/></a>)x"},

    // Substitutions.
    {"arguments",
     R"x(<xacro:arg name="given" default="no"/><xacro:arg name="own" default="${1+1}"/>
        <xacro:arg name="third" default="$(arg own)0"/><xacro:arg name="none" default=""/>
        <a b="$(arg given)" c="$(arg own)" d="$(arg third)" e="$(arg none)"/>${xacro.arg('given')})x",
     R"x(<a b="yes" c="2" d="20" e=""/>yes)x"},
    {"arguments are texts, properties of them are not",
     R"x(<xacro:arg name="n" default="0.5"/><xacro:property name="p" value="$(arg n)"/>
        ${p + 1} ${'$(arg n)' * 2} $(arg ${'n'}))x",
     "1.5 0.50.5 0.5"},
    {"the environment",
     "$(env ROBOT) $(optenv ROBOT none) $(optenv NOTHING a  b) [$(optenv NOTHING)]",
     "r2 r2 a b []"},
    {"packages and folders", "$(find arm_pkg)/urdf $(cwd) $(dirname)",
     "/opt/share/arm_pkg/urdf /f /f"},
    {"an expression of arguments",
     R"x(<xacro:arg name="n" default="4"/><xacro:arg name="on" default="true"/>
        $(eval n * 2) $(eval 'a' if on else 'b') $(eval true) $(eval 2*pi > 6 and not false))x",
     "8 a True True"},
    {"dollars", R"x(<a b="$" c="a $ b" d="$${x}" e="$$${x}" f="$$(x)" g="5$" h="$5"/>)x",
     R"x(<a b="$" c="a $ b" d="${x}" e="$${x}" f="$(x)" g="5$" h="$5"/>)x"},

    // Includes.
    {"an include", R"x(<xacro:include filename="wheel.xacro"/><xacro:wheel side="l"/>${radius})x",
     R"x(<tyre/><link name="l" r="0.25"/>0.25)x"},
    {"includes are relative to the file they stand in",
     R"x(<xacro:include filename="parts/arm.xacro"/>)x", "<hand/><tyre/>"},
    {"or, from a macro, to the file of its call",
     R"x(<xacro:macro name="load"><xacro:include filename="hand.xacro"/></xacro:macro><xacro:load/>
        <xacro:include filename="parts/caller.xacro"/><xacro:include filename="caller.xacro"/>)x",
     "<other_hand/><hand/><other_hand/>"},
    {"an include of a package, by a property",
     R"x(<xacro:property name="f" value="$(find arm_pkg)/urdf/arm.xacro"/>
        <xacro:include filename="${f}"/><xacro:include filename="${xacro.abs_filename('hand.xacro')}"/>)x",
     "<from_package/><other_hand/>"},
    {"includes by a pattern",
     R"x(<a><xacro:include filename="parts/h*.xacro"/></a><b><xacro:include filename="h[a-c]n?.xacro"/></b>
        <c><xacro:include filename="*/[!a]and.xacro"/></c><d><xacro:include filename="none*"/></d>
        <e><xacro:include filename="*r*t*/hand.xacro"/><xacro:include filename="w*.xacro" ns="w"/></e>
        ${w.radius})x",
     "<a><hand/></a><b><other_hand/></b><c><hand/></c><d/><e><hand/><tyre/></e>0.25"},
    {"an include that may be missing",
     R"x(<a/><xacro:include filename="none.xacro" optional="true"/><b/>)x", "<a/><b/>"},
    {"namespaces",
     R"x(<xacro:property name="outer" value="o"/><xacro:property name="radius" value="1"/>
        <xacro:include filename="wheel.xacro" ns="one"/><xacro:include filename="twin.xacro" ns="two"/>
        <xacro:one.wheel side="l"/><xacro:two.wheel side="${radius}"/>
        ${radius} ${one.radius * 2} ${two.radius} ${two.outer})x",
     R"x(<tyre/><link name="l" r="0.25"/><twin name="9" r="9" out="o"/>1 0.5 9 o)x"},
    {"scopes of namespaces",
     R"x(<xacro:property name="p" value="root"/><xacro:include filename="outer.xacro" ns="out"/>
        <a p="${p}" out="${out.p}" low="${out.low.p}"/><xacro:out.low.mark/><b p="${p}"/>)x",
     R"x(<seen where="outer" p="given"/><a p="root" out="given" low="mine"/><b p="marked"/>)x"},
    {"prefixes come along", R"x(<a><xacro:include filename="prefixed.xacro"/></a>)x",
     R"x(<a xmlns:gz="http://gz"><gz:light/></a>)x"},

    // Comments and the rest.
    {"comments before what goes, go; a blank line keeps them",
     R"x(<!-- kept -->

        <!-- gone -->
        <!-- gone too -->
        <xacro:property name="x" value="1"/>
        <!-- gone -->
        <xacro:if value="1"><!-- inside --></xacro:if>
        <!-- kept ${x} -->
        <a/>
        <!-- last -->)x",
     "<!-- kept --><!-- inside --><!-- kept ${x} --><a/><!-- last -->"},
    {"comments that are evaluated",
     R"x(<xacro:property name="x" value="1"/><a><!-- xacro:eval-comments --><!-- ${x} -->
        <!-- ${x + 1} --><b/><!-- ${x} --><!-- xacro:eval-comments --><!-- ${x} -->
        <!-- xacro:eval-comments:off --><!-- ${x} --></a>)x",
     "<a><!-- 1 --><!-- 2 --><b/><!-- ${x} --><!-- 1 --><!-- ${x} --></a>"},
    {"CDATA stays as it is", "<a><![CDATA[${x} <b>]]></a>", "<a><![CDATA[${x} <b>]]></a>"},
    {"marks of XML", R"x(<a b="&lt;${'&lt;'}&amp;&quot;">${1 &lt; 2} &amp;</a>)x",
     R"x(<a b="&lt;&lt;&amp;&quot;">True &amp;</a>)x"},
    {"attributes of xacro go", R"x(<a xacro:note="x" b="1"/>)x", R"x(<a b="1"/>)x"},
    {"elements that only look like it", R"x(<include filename="x"/><arg name="a"/>)x",
     R"x(<include filename="x"/><arg name="a"/>)x"},
    {"letters of the world",
     R"x(<xacro:property name="b" value="ü🤖"/><a b="${b[1]}">${b * 2}</a>)x",
     R"x(<a b="🤖">ü🤖ü🤖</a>)x"},

    // Expressions.
    {"numbers as Python writes them",
     "${1/2} ${4/2} ${7//2} ${2**10} ${1e-5} ${1e16} ${0.1+0.2} ${-3 % 5} ${round(2.5)} "
     "${int(3.9)}",
     "0.5 2.0 3 1024 1e-05 1e+16 0.30000000000000004 2 2 3"},
    {"mathematics",
     "${sin(0)} ${cos(pi)} ${radians(180) == pi} ${math.sqrt(16)} ${floor(2.7)} ${atan2(1, 1)*4 == "
     "pi}",
     "0.0 -1.0 True 4.0 2 True"},
    {"texts",
     R"x(${'a_b'.split('_')[1]} ${'%05.2f|%s' % (1.5, 'x')} ${'x'.upper()} ${'ab' in 'cab'} ${u'ü'}
        ${'l' if True else 'r'}${'abc'[1:]}${'abc'[::-1]} ${'-'.join(['a', 'b'])})x",
     "b 01.50|x X True ü lbccba a-b"},
    {"lists",
     R"x(<xacro:property name="l" value="${[1, 2, 3]}"/>${[x*x for x in l if x > 1]} ${l[-1]} ${l[:2]}
        ${list(map(str, l))} ${max(l)} ${sorted([3, 1])} ${python.sum(l)} ${(1, 2)} ${(1,)}
        ${[i + k for i in [1, 2] for k in [10, 20]]} ${list(range(3))})x",
     "[4, 9] 3 [1, 2] ['1', '2', '3'] 3 [1, 3] 6 (1, 2) (1,) [11, 21, 12, 22] [0, 1, 2]"},
    {"dictionaries",
     R"x(<xacro:property name="d" value="${dict(a=1, b=dict(c='x'))}"/>${d} ${d['b']['c']} ${'a' in d}
        ${list(d.keys())} ${[k + str(v) for k, v in dict(z=3).items()]}
        <xacro:property name="e" value="${xacro.dotify(d)}"/>${e.b.c} ${d.get('q', 0)})x",
     "{'a': 1, 'b': {'c': 'x'}} x True ['a', 'b'] ['z3'] x 0"},
    {"words of a text", "${xacro.tokenize('a, b;c')} ${xacro.tokenize('a::b', ':', False)}",
     "['a', 'b', 'c'] ['a', '', 'b']"},
    {"messages leave nothing", "[${xacro.message('x')}${xacro.warning('y', 2)}]", "[]"},

    // YAML.
    {"YAML",
     R"x(<xacro:property name="arms" value="${xacro.load_yaml('arms.yaml')}"/>
        ${arms['left']['length'] + 1} ${arms.left.joints[1]} ${arms.left['ok']}${arms.left[3]} ${arms.right.length}
        ${arms.right.file} ${arms.right.none} ${arms.right.small} ${arms.right.quoted}
        ${arms.heavy.mass}${arms.heavy.name} ${'right' in arms} ${len(arms.right.joints)})x",
     "1.5 elbow Truethree 0.0015 007 None 1e-3 yes 16b True 0"},
    {"numbers with units",
     R"x(<xacro:property name="t" value="${load_yaml('turns.yaml')}"/>${t.half} ${t.quarter * 2} ${t.step})x",
     "3.141592653589793 3.141592653589793 0.005"},
    {"lists of YAML",
     "${[i.at.x * 2 for i in xacro.load_yaml('list.yaml')]} "
     "${xacro.load_yaml('list.yaml')[1].name}",
     "[2, 4] b"},
    {"what YAML chooses",
     R"x(<xacro:property name="which" value="parts"/><xacro:property name="d"
        value="${dict(parts=dict(file='parts/hand.xacro'))}"/><xacro:include filename="${d[which]['file']}"/>)x",
     "<hand/>"},
};

TEST(Xacro, DocumentsComeToWhatTheyComeToNatively) {
  for (const auto& [what, document, result] : kCases) {
    const auto expanded = expand(robot(document), {{"given", "yes"}});
    ASSERT_TRUE(expanded.ok()) << what << ": " << expanded.errors().front().message;
    EXPECT_EQ(tree(*expanded), tree("<r>" + std::string(result) + "</r>")) << what << *expanded;
  }
}

TEST(Xacro, TheRootMayHaveANamespace) {
  const auto expanded = expand(
      R"x(<a xmlns:xacro="http://x" xacro:targetNamespace="http://y" b="${1}"><c xacro:targetNamespace="z"/></a>)x");
  ASSERT_TRUE(expanded.ok());
  EXPECT_EQ(*expanded, "<a b=\"1\" xmlns=\"http://y\">\n  <c/>\n</a>\n");
}

}  // namespace
}  // namespace ros2wasm
