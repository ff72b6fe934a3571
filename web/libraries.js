var Libraries=(()=>{var Dd=Object.defineProperty;var HE=Object.getOwnPropertyDescriptor;var WE=Object.getOwnPropertyNames;var $E=Object.prototype.hasOwnProperty;var XE=(e,t)=>{for(var n in t)Dd(e,n,{get:t[n],enumerable:!0})},qE=(e,t,n,i)=>{if(t&&typeof t=="object"||typeof t=="function")for(let r of WE(t))!$E.call(e,r)&&r!==n&&Dd(e,r,{get:()=>t[r],enumerable:!(i=HE(t,r))||i.enumerable});return e};var YE=e=>qE(Dd({},"__esModule",{value:!0}),e);var Z5={};XE(Z5,{BackSide:()=>an,BufferAttribute:()=>Jn,BufferGeometry:()=>Kn,DataTexture:()=>Uo,DirectionalLight:()=>_c,FrontSide:()=>Di,Group:()=>hr,HemisphereLight:()=>pc,LineBasicMaterial:()=>Fo,LineSegments:()=>sc,LinearFilter:()=>sn,Matrix4:()=>de,Mesh:()=>jn,MeshBasicMaterial:()=>Do,MeshLambertMaterial:()=>fc,OrbitControls:()=>Df,PerspectiveCamera:()=>vn,Plane:()=>xn,Raycaster:()=>yc,SRGBColorSpace:()=>yn,Scene:()=>nc,SphereGeometry:()=>uc,Spherical:()=>Qr,Vector2:()=>Ft,Vector3:()=>V,WebGLRenderer:()=>Pf,barX:()=>By,dot:()=>ky,line:()=>zy,plot:()=>Ll,pointer:()=>Ml,rectY:()=>Iy,ruleX:()=>wl,ruleY:()=>Tl,text:()=>ka,tip:()=>Pl});var ts={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},es={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Cx=0,up=1,Rx=2;var vc=1,Px=2,ko=3,Di=0,an=1,Ui=2,Ps=0,zo=1,fp=2,hp=3,dp=4,Ix=5;var Is=100,Lx=101,Nx=102,Dx=103,Ux=104,Fx=200,Ox=201,Bx=202,kx=203,pp=204,mp=205,zx=206,Gx=207,Vx=208,Hx=209,Wx=210,$x=211,Xx=212,qx=213,Yx=214,ou=0,au=1,cu=2,Eo=3,lu=4,uu=5,fu=6,hu=7,ku=0,Zx=1,Jx=2,Fi=0,gp=1,_p=2,yp=3,xp=4,vp=5,bp=6,Mp=7;var Sp=300,Ls=301,Go=302,zu=303,Gu=304,du=1e3,Li=1001,pu=1002,Ye=1003,Kx=1004;var bc=1005;var sn=1006,Vu=1007;var yr=1008;var En=1009,wp=1010,Tp=1011,Vo=1012,Hu=1013,bi=1014,Mi=1015,Si=1016,Wu=1017,$u=1018,Ns=1020,Ap=35902,Ep=35899,Cp=1021,Rp=1022,wi=1023,pr=1026,xr=1027,Pp=1028,Xu=1029,ns=1030,qu=1031;var Yu=1033,Mc=33776,Sc=33777,wc=33778,Tc=33779,Zu=35840,Ju=35841,Ku=35842,ju=35843,Qu=36196,tf=37492,ef=37496,nf=37488,rf=37489,Ac=37490,sf=37491,of=37808,af=37809,cf=37810,lf=37811,uf=37812,ff=37813,hf=37814,df=37815,pf=37816,mf=37817,gf=37818,_f=37819,yf=37820,xf=37821,vf=36492,bf=36494,Mf=36495,Sf=36283,wf=36284,Ec=36285,Tf=36286;var Ka=2300,mu=2301,ru=2302,np=2303,ip=2400,rp=2401,sp=2402;var jx=3200;var Af=0,Qx=1,vr="",yn="srgb",ja="srgb-linear",Qa="linear",le="srgb";var su=7680;var tv=519,ev=512,nv=513,iv=514,Ip=515,rv=516,sv=517,Lp=518,Np=519,ov=35044;var Dp="300 es",Zn=2e3,Co=2001;function ZE(e){for(let t=e.length-1;t>=0;--t)if(e[t]>=65535)return!0;return!1}function JE(e){return ArrayBuffer.isView(e)&&!(e instanceof DataView)}function tc(e){return document.createElementNS("http://www.w3.org/1999/xhtml",e)}function av(){let e=tc("canvas");return e.style.display="block",e}var jy={},Ro=null;function Up(...e){let t="THREE."+e.shift();Ro?Ro("log",t,...e):console.log(t,...e)}function cv(e){let t=e[0];if(typeof t=="string"&&t.startsWith("TSL:")){let n=e[1];n&&n.isStackTrace?e[0]+=" "+n.getLocation():e[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return e}function Dt(...e){e=cv(e);let t="THREE."+e.shift();if(Ro)Ro("warn",t,...e);else{let n=e[0];n&&n.isStackTrace?console.warn(n.getError(t)):console.warn(t,...e)}}function Ot(...e){e=cv(e);let t="THREE."+e.shift();if(Ro)Ro("error",t,...e);else{let n=e[0];n&&n.isStackTrace?console.error(n.getError(t)):console.error(t,...e)}}function Ya(...e){let t=e.join(" ");t in jy||(jy[t]=!0,Dt(...e))}function lv(e,t,n){return new Promise(function(i,r){function s(){switch(e.clientWaitSync(t,e.SYNC_FLUSH_COMMANDS_BIT,0)){case e.WAIT_FAILED:r();break;case e.TIMEOUT_EXPIRED:setTimeout(s,n);break;default:i()}}setTimeout(s,n)})}var uv={[ou]:ou,[cu]:fu,[lu]:lu,[Eo]:uu,[au]:au,[fu]:cu,[hu]:hu,[uu]:Eo},vi=class{addEventListener(t,n){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(n)===-1&&i[t].push(n)}hasEventListener(t,n){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(n)!==-1}removeEventListener(t,n){let i=this._listeners;if(i===void 0)return;let r=i[t];if(r!==void 0){let s=r.indexOf(n);s!==-1&&r.splice(s,1)}}dispatchEvent(t){let n=this._listeners;if(n===void 0)return;let i=n[t.type];if(i!==void 0){t.target=this;let r=i.slice(0);for(let s=0,o=r.length;s<o;s++)r[s].call(this,t);t.target=null}}},dn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Qy=1234567,Za=Math.PI/180,Po=180/Math.PI;function Ho(){let e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(dn[e&255]+dn[e>>8&255]+dn[e>>16&255]+dn[e>>24&255]+"-"+dn[t&255]+dn[t>>8&255]+"-"+dn[t>>16&15|64]+dn[t>>24&255]+"-"+dn[n&63|128]+dn[n>>8&255]+"-"+dn[n>>16&255]+dn[n>>24&255]+dn[i&255]+dn[i>>8&255]+dn[i>>16&255]+dn[i>>24&255]).toLowerCase()}function Kt(e,t,n){return Math.max(t,Math.min(n,e))}function Fp(e,t){return(e%t+t)%t}function KE(e,t,n,i,r){return i+(e-t)*(r-i)/(n-t)}function jE(e,t,n){return e!==t?(n-e)/(t-e):0}function Ja(e,t,n){return(1-n)*e+n*t}function QE(e,t,n,i){return Ja(e,t,1-Math.exp(-n*i))}function t2(e,t=1){return t-Math.abs(Fp(e,t*2)-t)}function e2(e,t,n){return e<=t?0:e>=n?1:(e=(e-t)/(n-t),e*e*(3-2*e))}function n2(e,t,n){return e<=t?0:e>=n?1:(e=(e-t)/(n-t),e*e*e*(e*(e*6-15)+10))}function i2(e,t){return e+Math.floor(Math.random()*(t-e+1))}function r2(e,t){return e+Math.random()*(t-e)}function s2(e){return e*(.5-Math.random())}function o2(e){e!==void 0&&(Qy=e);let t=Qy+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function a2(e){return e*Za}function c2(e){return e*Po}function l2(e){return e>0&&Number.isInteger(e)&&2**Math.round(Math.log2(e))===e}function u2(e){return Math.pow(2,Math.ceil(Math.log(e)/Math.LN2))}function Op(e){return Math.pow(2,Math.floor(Math.log(e)/Math.LN2))}function f2(e,t,n,i,r){let s=Math.cos,o=Math.sin,a=s(n/2),c=o(n/2),l=s((t+i)/2),u=o((t+i)/2),h=s((t-i)/2),f=o((t-i)/2),d=s((i-t)/2),p=o((i-t)/2);switch(r){case"XYX":e.set(a*u,c*h,c*f,a*l);break;case"YZY":e.set(c*f,a*u,c*h,a*l);break;case"ZXZ":e.set(c*h,c*f,a*u,a*l);break;case"XZX":e.set(a*u,c*p,c*d,a*l);break;case"YXY":e.set(c*d,a*u,c*p,a*l);break;case"ZYZ":e.set(c*p,c*d,a*u,a*l);break;default:Dt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+r)}}function Bp(e){switch(e.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function fv(e,t){if(t.constructor===Float32Array)return e;let n=Bp(t);if(n===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(e/n,-1)}function hv(e,t){if(t.constructor===Float32Array)return e;let n=Bp(t);if(n===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(e*n)}var kp={DEG2RAD:Za,RAD2DEG:Po,generateUUID:Ho,clamp:Kt,euclideanModulo:Fp,mapLinear:KE,inverseLerp:jE,lerp:Ja,damp:QE,pingpong:t2,smoothstep:e2,smootherstep:n2,randInt:i2,randFloat:r2,randFloatSpread:s2,seededRandom:o2,degToRad:a2,radToDeg:c2,isPowerOfTwo:l2,ceilPowerOfTwo:u2,floorPowerOfTwo:Op,setQuaternionFromProperEuler:f2,normalize:hv,denormalize:fv},Wp=class Wp{constructor(t=0,n=0){this.x=t,this.y=n}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,n){return this.x=t,this.y=n,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,n){switch(t){case 0:this.x=n;break;case 1:this.y=n;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,n){return this.x=t.x+n.x,this.y=t.y+n.y,this}addScaledVector(t,n){return this.x+=t.x*n,this.y+=t.y*n,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,n){return this.x=t.x-n.x,this.y=t.y-n.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let n=this.x,i=this.y,r=t.elements;return this.x=r[0]*n+r[3]*i+r[6],this.y=r[1]*n+r[4]*i+r[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,n){return this.x=Kt(this.x,t.x,n.x),this.y=Kt(this.y,t.y,n.y),this}clampScalar(t,n){return this.x=Kt(this.x,t,n),this.y=Kt(this.y,t,n),this}clampLength(t,n){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Kt(i,t,n))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let n=Math.sqrt(this.lengthSq()*t.lengthSq());if(n===0)return Math.PI/2;let i=this.dot(t)/n;return Math.acos(Kt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let n=this.x-t.x,i=this.y-t.y;return n*n+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,n){return this.x+=(t.x-this.x)*n,this.y+=(t.y-this.y)*n,this}lerpVectors(t,n,i){return this.x=t.x+(n.x-t.x)*i,this.y=t.y+(n.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,n=0){return this.x=t[n],this.y=t[n+1],this}toArray(t=[],n=0){return t[n]=this.x,t[n+1]=this.y,t}fromBufferAttribute(t,n){return this.x=t.getX(n),this.y=t.getY(n),this}rotateAround(t,n){let i=Math.cos(n),r=Math.sin(n),s=this.x-t.x,o=this.y-t.y;return this.x=s*i-o*r+t.x,this.y=s*r+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};Wp.prototype.isVector2=!0;var Ft=Wp,On=class{constructor(t=0,n=0,i=0,r=1){this.isQuaternion=!0,this._x=t,this._y=n,this._z=i,this._w=r}static slerpFlat(t,n,i,r,s,o,a){let c=i[r+0],l=i[r+1],u=i[r+2],h=i[r+3],f=s[o+0],d=s[o+1],p=s[o+2],_=s[o+3];if(h!==_||c!==f||l!==d||u!==p){let g=c*f+l*d+u*p+h*_;g<0&&(f=-f,d=-d,p=-p,_=-_,g=-g);let m=1-a;if(g<.9995){let x=Math.acos(g),S=Math.sin(x);m=Math.sin(m*x)/S,a=Math.sin(a*x)/S,c=c*m+f*a,l=l*m+d*a,u=u*m+p*a,h=h*m+_*a}else{c=c*m+f*a,l=l*m+d*a,u=u*m+p*a,h=h*m+_*a;let x=1/Math.sqrt(c*c+l*l+u*u+h*h);c*=x,l*=x,u*=x,h*=x}}t[n]=c,t[n+1]=l,t[n+2]=u,t[n+3]=h}static multiplyQuaternionsFlat(t,n,i,r,s,o){let a=i[r],c=i[r+1],l=i[r+2],u=i[r+3],h=s[o],f=s[o+1],d=s[o+2],p=s[o+3];return t[n]=a*p+u*h+c*d-l*f,t[n+1]=c*p+u*f+l*h-a*d,t[n+2]=l*p+u*d+a*f-c*h,t[n+3]=u*p-a*h-c*f-l*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,n,i,r){return this._x=t,this._y=n,this._z=i,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,n=!0){let i=t._x,r=t._y,s=t._z,o=t._order,a=Math.cos,c=Math.sin,l=a(i/2),u=a(r/2),h=a(s/2),f=c(i/2),d=c(r/2),p=c(s/2);switch(o){case"XYZ":this._x=f*u*h+l*d*p,this._y=l*d*h-f*u*p,this._z=l*u*p+f*d*h,this._w=l*u*h-f*d*p;break;case"YXZ":this._x=f*u*h+l*d*p,this._y=l*d*h-f*u*p,this._z=l*u*p-f*d*h,this._w=l*u*h+f*d*p;break;case"ZXY":this._x=f*u*h-l*d*p,this._y=l*d*h+f*u*p,this._z=l*u*p+f*d*h,this._w=l*u*h-f*d*p;break;case"ZYX":this._x=f*u*h-l*d*p,this._y=l*d*h+f*u*p,this._z=l*u*p-f*d*h,this._w=l*u*h+f*d*p;break;case"YZX":this._x=f*u*h+l*d*p,this._y=l*d*h+f*u*p,this._z=l*u*p-f*d*h,this._w=l*u*h-f*d*p;break;case"XZY":this._x=f*u*h-l*d*p,this._y=l*d*h-f*u*p,this._z=l*u*p+f*d*h,this._w=l*u*h+f*d*p;break;default:Dt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return n===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,n){let i=n/2,r=Math.sin(i);return this._x=t.x*r,this._y=t.y*r,this._z=t.z*r,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let n=t.elements,i=n[0],r=n[4],s=n[8],o=n[1],a=n[5],c=n[9],l=n[2],u=n[6],h=n[10],f=i+a+h;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-c)*d,this._y=(s-l)*d,this._z=(o-r)*d}else if(i>a&&i>h){let d=2*Math.sqrt(1+i-a-h);this._w=(u-c)/d,this._x=.25*d,this._y=(r+o)/d,this._z=(s+l)/d}else if(a>h){let d=2*Math.sqrt(1+a-i-h);this._w=(s-l)/d,this._x=(r+o)/d,this._y=.25*d,this._z=(c+u)/d}else{let d=2*Math.sqrt(1+h-i-a);this._w=(o-r)/d,this._x=(s+l)/d,this._y=(c+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,n){let i=t.dot(n)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*n.z-t.z*n.y,this._y=t.z*n.x-t.x*n.z,this._z=t.x*n.y-t.y*n.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Kt(this.dot(t),-1,1)))}rotateTowards(t,n){let i=this.angleTo(t);if(i===0)return this;let r=Math.min(1,n/i);return this.slerp(t,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,n){let i=t._x,r=t._y,s=t._z,o=t._w,a=n._x,c=n._y,l=n._z,u=n._w;return this._x=i*u+o*a+r*l-s*c,this._y=r*u+o*c+s*a-i*l,this._z=s*u+o*l+i*c-r*a,this._w=o*u-i*a-r*c-s*l,this._onChangeCallback(),this}slerp(t,n){let i=t._x,r=t._y,s=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,r=-r,s=-s,o=-o,a=-a);let c=1-n;if(a<.9995){let l=Math.acos(a),u=Math.sin(l);c=Math.sin(c*l)/u,n=Math.sin(n*l)/u,this._x=this._x*c+i*n,this._y=this._y*c+r*n,this._z=this._z*c+s*n,this._w=this._w*c+o*n,this._onChangeCallback()}else this._x=this._x*c+i*n,this._y=this._y*c+r*n,this._z=this._z*c+s*n,this._w=this._w*c+o*n,this.normalize();return this}slerpQuaternions(t,n,i){return this.copy(t).slerp(n,i)}random(){let t=2*Math.PI*Math.random(),n=2*Math.PI*Math.random(),i=Math.random(),r=Math.sqrt(1-i),s=Math.sqrt(i);return this.set(r*Math.sin(t),r*Math.cos(t),s*Math.sin(n),s*Math.cos(n))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,n=0){return this._x=t[n],this._y=t[n+1],this._z=t[n+2],this._w=t[n+3],this._onChangeCallback(),this}toArray(t=[],n=0){return t[n]=this._x,t[n+1]=this._y,t[n+2]=this._z,t[n+3]=this._w,t}fromBufferAttribute(t,n){return this._x=t.getX(n),this._y=t.getY(n),this._z=t.getZ(n),this._w=t.getW(n),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},$p=class $p{constructor(t=0,n=0,i=0){this.x=t,this.y=n,this.z=i}set(t,n,i){return i===void 0&&(i=this.z),this.x=t,this.y=n,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,n){switch(t){case 0:this.x=n;break;case 1:this.y=n;break;case 2:this.z=n;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,n){return this.x=t.x+n.x,this.y=t.y+n.y,this.z=t.z+n.z,this}addScaledVector(t,n){return this.x+=t.x*n,this.y+=t.y*n,this.z+=t.z*n,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,n){return this.x=t.x-n.x,this.y=t.y-n.y,this.z=t.z-n.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,n){return this.x=t.x*n.x,this.y=t.y*n.y,this.z=t.z*n.z,this}applyEuler(t){return this.applyQuaternion(tx.setFromEuler(t))}applyAxisAngle(t,n){return this.applyQuaternion(tx.setFromAxisAngle(t,n))}applyMatrix3(t){let n=this.x,i=this.y,r=this.z,s=t.elements;return this.x=s[0]*n+s[3]*i+s[6]*r,this.y=s[1]*n+s[4]*i+s[7]*r,this.z=s[2]*n+s[5]*i+s[8]*r,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let n=this.x,i=this.y,r=this.z,s=t.elements,o=1/(s[3]*n+s[7]*i+s[11]*r+s[15]);return this.x=(s[0]*n+s[4]*i+s[8]*r+s[12])*o,this.y=(s[1]*n+s[5]*i+s[9]*r+s[13])*o,this.z=(s[2]*n+s[6]*i+s[10]*r+s[14])*o,this}applyQuaternion(t){let n=this.x,i=this.y,r=this.z,s=t.x,o=t.y,a=t.z,c=t.w,l=2*(o*r-a*i),u=2*(a*n-s*r),h=2*(s*i-o*n);return this.x=n+c*l+o*h-a*u,this.y=i+c*u+a*l-s*h,this.z=r+c*h+s*u-o*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let n=this.x,i=this.y,r=this.z,s=t.elements;return this.x=s[0]*n+s[4]*i+s[8]*r,this.y=s[1]*n+s[5]*i+s[9]*r,this.z=s[2]*n+s[6]*i+s[10]*r,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,n){return this.x=Kt(this.x,t.x,n.x),this.y=Kt(this.y,t.y,n.y),this.z=Kt(this.z,t.z,n.z),this}clampScalar(t,n){return this.x=Kt(this.x,t,n),this.y=Kt(this.y,t,n),this.z=Kt(this.z,t,n),this}clampLength(t,n){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Kt(i,t,n))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,n){return this.x+=(t.x-this.x)*n,this.y+=(t.y-this.y)*n,this.z+=(t.z-this.z)*n,this}lerpVectors(t,n,i){return this.x=t.x+(n.x-t.x)*i,this.y=t.y+(n.y-t.y)*i,this.z=t.z+(n.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,n){let i=t.x,r=t.y,s=t.z,o=n.x,a=n.y,c=n.z;return this.x=r*c-s*a,this.y=s*o-i*c,this.z=i*a-r*o,this}projectOnVector(t){let n=t.lengthSq();if(n===0)return this.set(0,0,0);let i=t.dot(this)/n;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Ud.copy(this).projectOnVector(t),this.sub(Ud)}reflect(t){return this.sub(Ud.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let n=Math.sqrt(this.lengthSq()*t.lengthSq());if(n===0)return Math.PI/2;let i=this.dot(t)/n;return Math.acos(Kt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let n=this.x-t.x,i=this.y-t.y,r=this.z-t.z;return n*n+i*i+r*r}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,n,i){let r=Math.sin(n)*t;return this.x=r*Math.sin(i),this.y=Math.cos(n)*t,this.z=r*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,n,i){return this.x=t*Math.sin(n),this.y=i,this.z=t*Math.cos(n),this}setFromMatrixPosition(t){let n=t.elements;return this.x=n[12],this.y=n[13],this.z=n[14],this}setFromMatrixScale(t){let n=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),r=this.setFromMatrixColumn(t,2).length();return this.x=n,this.y=i,this.z=r,this}setFromMatrixColumn(t,n){return this.fromArray(t.elements,n*4)}setFromMatrix3Column(t,n){return this.fromArray(t.elements,n*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,n=0){return this.x=t[n],this.y=t[n+1],this.z=t[n+2],this}toArray(t=[],n=0){return t[n]=this.x,t[n+1]=this.y,t[n+2]=this.z,t}fromBufferAttribute(t,n){return this.x=t.getX(n),this.y=t.getY(n),this.z=t.getZ(n),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,n=Math.random()*2-1,i=Math.sqrt(1-n*n);return this.x=i*Math.cos(t),this.y=n,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}};$p.prototype.isVector3=!0;var V=$p,Ud=new V,tx=new On,Xp=class Xp{constructor(t,n,i,r,s,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,n,i,r,s,o,a,c,l)}set(t,n,i,r,s,o,a,c,l){let u=this.elements;return u[0]=t,u[1]=r,u[2]=a,u[3]=n,u[4]=s,u[5]=c,u[6]=i,u[7]=o,u[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let n=this.elements,i=t.elements;return n[0]=i[0],n[1]=i[1],n[2]=i[2],n[3]=i[3],n[4]=i[4],n[5]=i[5],n[6]=i[6],n[7]=i[7],n[8]=i[8],this}extractBasis(t,n,i){return t.setFromMatrix3Column(this,0),n.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let n=t.elements;return this.set(n[0],n[4],n[8],n[1],n[5],n[9],n[2],n[6],n[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,n){let i=t.elements,r=n.elements,s=this.elements,o=i[0],a=i[3],c=i[6],l=i[1],u=i[4],h=i[7],f=i[2],d=i[5],p=i[8],_=r[0],g=r[3],m=r[6],x=r[1],S=r[4],v=r[7],w=r[2],b=r[5],y=r[8];return s[0]=o*_+a*x+c*w,s[3]=o*g+a*S+c*b,s[6]=o*m+a*v+c*y,s[1]=l*_+u*x+h*w,s[4]=l*g+u*S+h*b,s[7]=l*m+u*v+h*y,s[2]=f*_+d*x+p*w,s[5]=f*g+d*S+p*b,s[8]=f*m+d*v+p*y,this}multiplyScalar(t){let n=this.elements;return n[0]*=t,n[3]*=t,n[6]*=t,n[1]*=t,n[4]*=t,n[7]*=t,n[2]*=t,n[5]*=t,n[8]*=t,this}determinant(){let t=this.elements,n=t[0],i=t[1],r=t[2],s=t[3],o=t[4],a=t[5],c=t[6],l=t[7],u=t[8];return n*o*u-n*a*l-i*s*u+i*a*c+r*s*l-r*o*c}invert(){let t=this.elements,n=t[0],i=t[1],r=t[2],s=t[3],o=t[4],a=t[5],c=t[6],l=t[7],u=t[8],h=u*o-a*l,f=a*c-u*s,d=l*s-o*c,p=n*h+i*f+r*d;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/p;return t[0]=h*_,t[1]=(r*l-u*i)*_,t[2]=(a*i-r*o)*_,t[3]=f*_,t[4]=(u*n-r*c)*_,t[5]=(r*s-a*n)*_,t[6]=d*_,t[7]=(i*c-l*n)*_,t[8]=(o*n-i*s)*_,this}transpose(){let t,n=this.elements;return t=n[1],n[1]=n[3],n[3]=t,t=n[2],n[2]=n[6],n[6]=t,t=n[5],n[5]=n[7],n[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let n=this.elements;return t[0]=n[0],t[1]=n[3],t[2]=n[6],t[3]=n[1],t[4]=n[4],t[5]=n[7],t[6]=n[2],t[7]=n[5],t[8]=n[8],this}setUvTransform(t,n,i,r,s,o,a){let c=Math.cos(s),l=Math.sin(s);return this.set(i*c,i*l,-i*(c*o+l*a)+o+t,-r*l,r*c,-r*(-l*o+c*a)+a+n,0,0,1),this}scale(t,n){return Ya("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Fd.makeScale(t,n)),this}rotate(t){return Ya("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Fd.makeRotation(-t)),this}translate(t,n){return Ya("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Fd.makeTranslation(t,n)),this}makeTranslation(t,n){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,n,0,0,1),this}makeRotation(t){let n=Math.cos(t),i=Math.sin(t);return this.set(n,-i,0,i,n,0,0,0,1),this}makeScale(t,n){return this.set(t,0,0,0,n,0,0,0,1),this}equals(t){let n=this.elements,i=t.elements;for(let r=0;r<9;r++)if(n[r]!==i[r])return!1;return!0}fromArray(t,n=0){for(let i=0;i<9;i++)this.elements[i]=t[i+n];return this}toArray(t=[],n=0){let i=this.elements;return t[n]=i[0],t[n+1]=i[1],t[n+2]=i[2],t[n+3]=i[3],t[n+4]=i[4],t[n+5]=i[5],t[n+6]=i[6],t[n+7]=i[7],t[n+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}};Xp.prototype.isMatrix3=!0;var kt=Xp,Fd=new kt,ex=new kt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),nx=new kt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function h2(){let e={enabled:!0,workingColorSpace:ja,spaces:{},convert:function(r,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===le&&(r.r=dr(r.r),r.g=dr(r.g),r.b=dr(r.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===le&&(r.r=Ao(r.r),r.g=Ao(r.g),r.b=Ao(r.b))),r},workingToColorSpace:function(r,s){return this.convert(r,this.workingColorSpace,s)},colorSpaceToWorking:function(r,s){return this.convert(r,s,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===vr?Qa:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,s,o){return r.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],n=[.2126,.7152,.0722],i=[.3127,.329];return e.define({[ja]:{primaries:t,whitePoint:i,transfer:Qa,toXYZ:ex,fromXYZ:nx,luminanceCoefficients:n,workingColorSpaceConfig:{unpackColorSpace:yn},outputColorSpaceConfig:{drawingBufferColorSpace:yn}},[yn]:{primaries:t,whitePoint:i,transfer:le,toXYZ:ex,fromXYZ:nx,luminanceCoefficients:n,outputColorSpaceConfig:{drawingBufferColorSpace:yn}}}),e}var ne=h2();function dr(e){return e<.04045?e*.0773993808:Math.pow(e*.9478672986+.0521327014,2.4)}function Ao(e){return e<.0031308?e*12.92:1.055*Math.pow(e,.41666)-.055}var ho,gu=class{static getDataURL(t,n="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{ho===void 0&&(ho=tc("canvas")),ho.width=t.width,ho.height=t.height;let r=ho.getContext("2d");t instanceof ImageData?r.putImageData(t,0,0):r.drawImage(t,0,0,t.width,t.height),i=ho}return i.toDataURL(n)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let n=tc("canvas");n.width=t.width,n.height=t.height;let i=n.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let r=i.getImageData(0,0,t.width,t.height),s=r.data;for(let o=0;o<s.length;o++)s[o]=dr(s[o]/255)*255;return i.putImageData(r,0,0),n}else if(t.data){let n=t.data.slice(0);for(let i=0;i<n.length;i++)n instanceof Uint8Array||n instanceof Uint8ClampedArray?n[i]=Math.floor(dr(n[i]/255)*255):n[i]=dr(n[i]);return{data:n,width:t.width,height:t.height}}else return Dt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},d2=0,Io=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:d2++}),this.uuid=Ho(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let n=this.data;return typeof HTMLVideoElement<"u"&&n instanceof HTMLVideoElement?t.set(n.videoWidth,n.videoHeight,0):typeof VideoFrame<"u"&&n instanceof VideoFrame?t.set(n.displayWidth,n.displayHeight,0):n!==null?t.set(n.width||0,n.height||0,n.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let n=t===void 0||typeof t=="string";if(!n&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let o=0,a=r.length;o<a;o++)r[o].isDataTexture?s.push(Od(r[o].image)):s.push(Od(r[o]))}else s=Od(r);i.url=s}return n||(t.images[this.uuid]=i),i}};function Od(e){return typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap?gu.getDataURL(e):e.data?{data:Array.from(e.data),width:e.width,height:e.height,type:e.data.constructor.name}:(Dt("Texture: Unable to serialize Texture."),{})}var p2=0,Bd=new V,An=class e extends vi{constructor(t=e.DEFAULT_IMAGE,n=e.DEFAULT_MAPPING,i=Li,r=Li,s=sn,o=yr,a=wi,c=En,l=e.DEFAULT_ANISOTROPY,u=vr){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:p2++}),this.uuid=Ho(),this.name="",this.source=new Io(t),this.mipmaps=[],this.mapping=n,this.channel=0,this.wrapS=i,this.wrapT=r,this.magFilter=s,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new Ft(0,0),this.repeat=new Ft(1,1),this.center=new Ft(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new kt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Bd).x}get height(){return this.source.getSize(Bd).y}get depth(){return this.source.getSize(Bd).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,n){this.updateRanges.push({start:t,count:n})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let n in t){let i=t[n];if(i===void 0){Dt(`Texture.setValues(): parameter '${n}' has value of undefined.`);continue}let r=this[n];if(r===void 0){Dt(`Texture.setValues(): property '${n}' does not exist.`);continue}r&&i&&r.isVector2&&i.isVector2||r&&i&&r.isVector3&&i.isVector3||r&&i&&r.isMatrix3&&i.isMatrix3?r.copy(i):this[n]=i}}toJSON(t){let n=t===void 0||typeof t=="string";if(!n&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),n||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Sp)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case du:t.x=t.x-Math.floor(t.x);break;case Li:t.x=t.x<0?0:1;break;case pu:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case du:t.y=t.y-Math.floor(t.y);break;case Li:t.y=t.y<0?0:1;break;case pu:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};An.DEFAULT_IMAGE=null;An.DEFAULT_MAPPING=Sp;An.DEFAULT_ANISOTROPY=1;var qp=class qp{constructor(t=0,n=0,i=0,r=1){this.x=t,this.y=n,this.z=i,this.w=r}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,n,i,r){return this.x=t,this.y=n,this.z=i,this.w=r,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,n){switch(t){case 0:this.x=n;break;case 1:this.y=n;break;case 2:this.z=n;break;case 3:this.w=n;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,n){return this.x=t.x+n.x,this.y=t.y+n.y,this.z=t.z+n.z,this.w=t.w+n.w,this}addScaledVector(t,n){return this.x+=t.x*n,this.y+=t.y*n,this.z+=t.z*n,this.w+=t.w*n,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,n){return this.x=t.x-n.x,this.y=t.y-n.y,this.z=t.z-n.z,this.w=t.w-n.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let n=this.x,i=this.y,r=this.z,s=this.w,o=t.elements;return this.x=o[0]*n+o[4]*i+o[8]*r+o[12]*s,this.y=o[1]*n+o[5]*i+o[9]*r+o[13]*s,this.z=o[2]*n+o[6]*i+o[10]*r+o[14]*s,this.w=o[3]*n+o[7]*i+o[11]*r+o[15]*s,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let n=Math.sqrt(1-t.w*t.w);return n<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/n,this.y=t.y/n,this.z=t.z/n),this}setAxisAngleFromRotationMatrix(t){let n,i,r,s,c=t.elements,l=c[0],u=c[4],h=c[8],f=c[1],d=c[5],p=c[9],_=c[2],g=c[6],m=c[10];if(Math.abs(u-f)<.01&&Math.abs(h-_)<.01&&Math.abs(p-g)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+_)<.1&&Math.abs(p+g)<.1&&Math.abs(l+d+m-3)<.1)return this.set(1,0,0,0),this;n=Math.PI;let S=(l+1)/2,v=(d+1)/2,w=(m+1)/2,b=(u+f)/4,y=(h+_)/4,M=(p+g)/4;return S>v&&S>w?S<.01?(i=0,r=.707106781,s=.707106781):(i=Math.sqrt(S),r=b/i,s=y/i):v>w?v<.01?(i=.707106781,r=0,s=.707106781):(r=Math.sqrt(v),i=b/r,s=M/r):w<.01?(i=.707106781,r=.707106781,s=0):(s=Math.sqrt(w),i=y/s,r=M/s),this.set(i,r,s,n),this}let x=Math.sqrt((g-p)*(g-p)+(h-_)*(h-_)+(f-u)*(f-u));return Math.abs(x)<.001&&(x=1),this.x=(g-p)/x,this.y=(h-_)/x,this.z=(f-u)/x,this.w=Math.acos((l+d+m-1)/2),this}setFromMatrixPosition(t){let n=t.elements;return this.x=n[12],this.y=n[13],this.z=n[14],this.w=n[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,n){return this.x=Kt(this.x,t.x,n.x),this.y=Kt(this.y,t.y,n.y),this.z=Kt(this.z,t.z,n.z),this.w=Kt(this.w,t.w,n.w),this}clampScalar(t,n){return this.x=Kt(this.x,t,n),this.y=Kt(this.y,t,n),this.z=Kt(this.z,t,n),this.w=Kt(this.w,t,n),this}clampLength(t,n){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Kt(i,t,n))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,n){return this.x+=(t.x-this.x)*n,this.y+=(t.y-this.y)*n,this.z+=(t.z-this.z)*n,this.w+=(t.w-this.w)*n,this}lerpVectors(t,n,i){return this.x=t.x+(n.x-t.x)*i,this.y=t.y+(n.y-t.y)*i,this.z=t.z+(n.z-t.z)*i,this.w=t.w+(n.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,n=0){return this.x=t[n],this.y=t[n+1],this.z=t[n+2],this.w=t[n+3],this}toArray(t=[],n=0){return t[n]=this.x,t[n+1]=this.y,t[n+2]=this.z,t[n+3]=this.w,t}fromBufferAttribute(t,n){return this.x=t.getX(n),this.y=t.getY(n),this.z=t.getZ(n),this.w=t.getW(n),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};qp.prototype.isVector4=!0;var we=qp,_u=class extends vi{constructor(t=1,n=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:sn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=n,this.depth=i.depth,this.scissor=new we(0,0,t,n),this.scissorTest=!1,this.viewport=new we(0,0,t,n),this.textures=[];let r=i.count;for(let s=0;s<r;s++)this.textures[s]=new An({width:t,height:n,depth:i.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let n={minFilter:sn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(n.mapping=t.mapping),t.wrapS!==void 0&&(n.wrapS=t.wrapS),t.wrapT!==void 0&&(n.wrapT=t.wrapT),t.wrapR!==void 0&&(n.wrapR=t.wrapR),t.magFilter!==void 0&&(n.magFilter=t.magFilter),t.minFilter!==void 0&&(n.minFilter=t.minFilter),t.format!==void 0&&(n.format=t.format),t.type!==void 0&&(n.type=t.type),t.anisotropy!==void 0&&(n.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(n.colorSpace=t.colorSpace),t.flipY!==void 0&&(n.flipY=t.flipY),t.generateMipmaps!==void 0&&(n.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(n.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(n.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(n)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,n,i=1){if(this.width!==t||this.height!==n||this.depth!==i){this.width=t,this.height=n,this.depth=i;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=t,this.textures[r].image.height=n,this.textures[r].image.depth=i,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,t,n),this.scissor.set(0,0,t,n)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let n=0,i=t.textures.length;n<i;n++){this.textures[n]=t.textures[n].clone(),this.textures[n].isRenderTargetTexture=!0,this.textures[n].renderTarget=this;let r=Object.assign({},t.textures[n].image);this.textures[n].source=new Io(r)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let n=t.depthTexture.clone();n.renderTarget=null,this.depthTexture=n}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Bn=class extends _u{constructor(t=1,n=1,i={}){super(t,n,i),this.isWebGLRenderTarget=!0}},ec=class extends An{constructor(t=null,n=1,i=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:n,height:i,depth:r},this.magFilter=Ye,this.minFilter=Ye,this.wrapR=Li,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var yu=class extends An{constructor(t=null,n=1,i=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:n,height:i,depth:r},this.magFilter=Ye,this.minFilter=Ye,this.wrapR=Li,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Bu=class Bu{constructor(t,n,i,r,s,o,a,c,l,u,h,f,d,p,_,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,n,i,r,s,o,a,c,l,u,h,f,d,p,_,g)}set(t,n,i,r,s,o,a,c,l,u,h,f,d,p,_,g){let m=this.elements;return m[0]=t,m[4]=n,m[8]=i,m[12]=r,m[1]=s,m[5]=o,m[9]=a,m[13]=c,m[2]=l,m[6]=u,m[10]=h,m[14]=f,m[3]=d,m[7]=p,m[11]=_,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Bu().fromArray(this.elements)}copy(t){let n=this.elements,i=t.elements;return n[0]=i[0],n[1]=i[1],n[2]=i[2],n[3]=i[3],n[4]=i[4],n[5]=i[5],n[6]=i[6],n[7]=i[7],n[8]=i[8],n[9]=i[9],n[10]=i[10],n[11]=i[11],n[12]=i[12],n[13]=i[13],n[14]=i[14],n[15]=i[15],this}copyPosition(t){let n=this.elements,i=t.elements;return n[12]=i[12],n[13]=i[13],n[14]=i[14],this}setFromMatrix3(t){let n=t.elements;return this.set(n[0],n[3],n[6],0,n[1],n[4],n[7],0,n[2],n[5],n[8],0,0,0,0,1),this}extractBasis(t,n,i){return this.determinantAffine()===0?(t.set(1,0,0),n.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),n.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,n,i){return this.set(t.x,n.x,i.x,0,t.y,n.y,i.y,0,t.z,n.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let n=this.elements,i=t.elements,r=1/po.setFromMatrixColumn(t,0).length(),s=1/po.setFromMatrixColumn(t,1).length(),o=1/po.setFromMatrixColumn(t,2).length();return n[0]=i[0]*r,n[1]=i[1]*r,n[2]=i[2]*r,n[3]=0,n[4]=i[4]*s,n[5]=i[5]*s,n[6]=i[6]*s,n[7]=0,n[8]=i[8]*o,n[9]=i[9]*o,n[10]=i[10]*o,n[11]=0,n[12]=0,n[13]=0,n[14]=0,n[15]=1,this}makeRotationFromEuler(t){let n=this.elements,i=t.x,r=t.y,s=t.z,o=Math.cos(i),a=Math.sin(i),c=Math.cos(r),l=Math.sin(r),u=Math.cos(s),h=Math.sin(s);if(t.order==="XYZ"){let f=o*u,d=o*h,p=a*u,_=a*h;n[0]=c*u,n[4]=-c*h,n[8]=l,n[1]=d+p*l,n[5]=f-_*l,n[9]=-a*c,n[2]=_-f*l,n[6]=p+d*l,n[10]=o*c}else if(t.order==="YXZ"){let f=c*u,d=c*h,p=l*u,_=l*h;n[0]=f+_*a,n[4]=p*a-d,n[8]=o*l,n[1]=o*h,n[5]=o*u,n[9]=-a,n[2]=d*a-p,n[6]=_+f*a,n[10]=o*c}else if(t.order==="ZXY"){let f=c*u,d=c*h,p=l*u,_=l*h;n[0]=f-_*a,n[4]=-o*h,n[8]=p+d*a,n[1]=d+p*a,n[5]=o*u,n[9]=_-f*a,n[2]=-o*l,n[6]=a,n[10]=o*c}else if(t.order==="ZYX"){let f=o*u,d=o*h,p=a*u,_=a*h;n[0]=c*u,n[4]=p*l-d,n[8]=f*l+_,n[1]=c*h,n[5]=_*l+f,n[9]=d*l-p,n[2]=-l,n[6]=a*c,n[10]=o*c}else if(t.order==="YZX"){let f=o*c,d=o*l,p=a*c,_=a*l;n[0]=c*u,n[4]=_-f*h,n[8]=p*h+d,n[1]=h,n[5]=o*u,n[9]=-a*u,n[2]=-l*u,n[6]=d*h+p,n[10]=f-_*h}else if(t.order==="XZY"){let f=o*c,d=o*l,p=a*c,_=a*l;n[0]=c*u,n[4]=-h,n[8]=l*u,n[1]=f*h+_,n[5]=o*u,n[9]=d*h-p,n[2]=p*h-d,n[6]=a*u,n[10]=_*h+f}return n[3]=0,n[7]=0,n[11]=0,n[12]=0,n[13]=0,n[14]=0,n[15]=1,this}makeRotationFromQuaternion(t){return this.compose(m2,t,g2)}lookAt(t,n,i){let r=this.elements;return Un.subVectors(t,n),Un.lengthSq()===0&&(Un.z=1),Un.normalize(),Gr.crossVectors(i,Un),Gr.lengthSq()===0&&(Math.abs(i.z)===1?Un.x+=1e-4:Un.z+=1e-4,Un.normalize(),Gr.crossVectors(i,Un)),Gr.normalize(),Fl.crossVectors(Un,Gr),r[0]=Gr.x,r[4]=Fl.x,r[8]=Un.x,r[1]=Gr.y,r[5]=Fl.y,r[9]=Un.y,r[2]=Gr.z,r[6]=Fl.z,r[10]=Un.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,n){let i=t.elements,r=n.elements,s=this.elements,o=i[0],a=i[4],c=i[8],l=i[12],u=i[1],h=i[5],f=i[9],d=i[13],p=i[2],_=i[6],g=i[10],m=i[14],x=i[3],S=i[7],v=i[11],w=i[15],b=r[0],y=r[4],M=r[8],R=r[12],C=r[1],E=r[5],N=r[9],k=r[13],P=r[2],L=r[6],B=r[10],U=r[14],Z=r[3],F=r[7],G=r[11],q=r[15];return s[0]=o*b+a*C+c*P+l*Z,s[4]=o*y+a*E+c*L+l*F,s[8]=o*M+a*N+c*B+l*G,s[12]=o*R+a*k+c*U+l*q,s[1]=u*b+h*C+f*P+d*Z,s[5]=u*y+h*E+f*L+d*F,s[9]=u*M+h*N+f*B+d*G,s[13]=u*R+h*k+f*U+d*q,s[2]=p*b+_*C+g*P+m*Z,s[6]=p*y+_*E+g*L+m*F,s[10]=p*M+_*N+g*B+m*G,s[14]=p*R+_*k+g*U+m*q,s[3]=x*b+S*C+v*P+w*Z,s[7]=x*y+S*E+v*L+w*F,s[11]=x*M+S*N+v*B+w*G,s[15]=x*R+S*k+v*U+w*q,this}multiplyScalar(t){let n=this.elements;return n[0]*=t,n[4]*=t,n[8]*=t,n[12]*=t,n[1]*=t,n[5]*=t,n[9]*=t,n[13]*=t,n[2]*=t,n[6]*=t,n[10]*=t,n[14]*=t,n[3]*=t,n[7]*=t,n[11]*=t,n[15]*=t,this}determinant(){let t=this.elements,n=t[0],i=t[4],r=t[8],s=t[12],o=t[1],a=t[5],c=t[9],l=t[13],u=t[2],h=t[6],f=t[10],d=t[14],p=t[3],_=t[7],g=t[11],m=t[15],x=c*d-l*f,S=a*d-l*h,v=a*f-c*h,w=o*d-l*u,b=o*f-c*u,y=o*h-a*u;return n*(_*x-g*S+m*v)-i*(p*x-g*w+m*b)+r*(p*S-_*w+m*y)-s*(p*v-_*b+g*y)}determinantAffine(){let t=this.elements,n=t[0],i=t[4],r=t[8],s=t[1],o=t[5],a=t[9],c=t[2],l=t[6],u=t[10];return n*(o*u-a*l)-i*(s*u-a*c)+r*(s*l-o*c)}transpose(){let t=this.elements,n;return n=t[1],t[1]=t[4],t[4]=n,n=t[2],t[2]=t[8],t[8]=n,n=t[6],t[6]=t[9],t[9]=n,n=t[3],t[3]=t[12],t[12]=n,n=t[7],t[7]=t[13],t[13]=n,n=t[11],t[11]=t[14],t[14]=n,this}setPosition(t,n,i){let r=this.elements;return t.isVector3?(r[12]=t.x,r[13]=t.y,r[14]=t.z):(r[12]=t,r[13]=n,r[14]=i),this}invert(){let t=this.elements,n=t[0],i=t[1],r=t[2],s=t[3],o=t[4],a=t[5],c=t[6],l=t[7],u=t[8],h=t[9],f=t[10],d=t[11],p=t[12],_=t[13],g=t[14],m=t[15],x=n*a-i*o,S=n*c-r*o,v=n*l-s*o,w=i*c-r*a,b=i*l-s*a,y=r*l-s*c,M=u*_-h*p,R=u*g-f*p,C=u*m-d*p,E=h*g-f*_,N=h*m-d*_,k=f*m-d*g,P=x*k-S*N+v*E+w*C-b*R+y*M;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let L=1/P;return t[0]=(a*k-c*N+l*E)*L,t[1]=(r*N-i*k-s*E)*L,t[2]=(_*y-g*b+m*w)*L,t[3]=(f*b-h*y-d*w)*L,t[4]=(c*C-o*k-l*R)*L,t[5]=(n*k-r*C+s*R)*L,t[6]=(g*v-p*y-m*S)*L,t[7]=(u*y-f*v+d*S)*L,t[8]=(o*N-a*C+l*M)*L,t[9]=(i*C-n*N-s*M)*L,t[10]=(p*b-_*v+m*x)*L,t[11]=(h*v-u*b-d*x)*L,t[12]=(a*R-o*E-c*M)*L,t[13]=(n*E-i*R+r*M)*L,t[14]=(_*S-p*w-g*x)*L,t[15]=(u*w-h*S+f*x)*L,this}scale(t){let n=this.elements,i=t.x,r=t.y,s=t.z;return n[0]*=i,n[4]*=r,n[8]*=s,n[1]*=i,n[5]*=r,n[9]*=s,n[2]*=i,n[6]*=r,n[10]*=s,n[3]*=i,n[7]*=r,n[11]*=s,this}getMaxScaleOnAxis(){let t=this.elements,n=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],r=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(n,i,r))}makeTranslation(t,n,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,n,0,0,1,i,0,0,0,1),this}makeRotationX(t){let n=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,n,-i,0,0,i,n,0,0,0,0,1),this}makeRotationY(t){let n=Math.cos(t),i=Math.sin(t);return this.set(n,0,i,0,0,1,0,0,-i,0,n,0,0,0,0,1),this}makeRotationZ(t){let n=Math.cos(t),i=Math.sin(t);return this.set(n,-i,0,0,i,n,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,n){let i=Math.cos(n),r=Math.sin(n),s=1-i,o=t.x,a=t.y,c=t.z,l=s*o,u=s*a;return this.set(l*o+i,l*a-r*c,l*c+r*a,0,l*a+r*c,u*a+i,u*c-r*o,0,l*c-r*a,u*c+r*o,s*c*c+i,0,0,0,0,1),this}makeScale(t,n,i){return this.set(t,0,0,0,0,n,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,n,i,r,s,o){return this.set(1,i,s,0,t,1,o,0,n,r,1,0,0,0,0,1),this}compose(t,n,i){let r=this.elements,s=n._x,o=n._y,a=n._z,c=n._w,l=s+s,u=o+o,h=a+a,f=s*l,d=s*u,p=s*h,_=o*u,g=o*h,m=a*h,x=c*l,S=c*u,v=c*h,w=i.x,b=i.y,y=i.z;return r[0]=(1-(_+m))*w,r[1]=(d+v)*w,r[2]=(p-S)*w,r[3]=0,r[4]=(d-v)*b,r[5]=(1-(f+m))*b,r[6]=(g+x)*b,r[7]=0,r[8]=(p+S)*y,r[9]=(g-x)*y,r[10]=(1-(f+_))*y,r[11]=0,r[12]=t.x,r[13]=t.y,r[14]=t.z,r[15]=1,this}decompose(t,n,i){let r=this.elements;t.x=r[12],t.y=r[13],t.z=r[14];let s=this.determinantAffine();if(s===0)return i.set(1,1,1),n.identity(),this;let o=po.set(r[0],r[1],r[2]).length(),a=po.set(r[4],r[5],r[6]).length(),c=po.set(r[8],r[9],r[10]).length();s<0&&(o=-o),_i.copy(this);let l=1/o,u=1/a,h=1/c;return _i.elements[0]*=l,_i.elements[1]*=l,_i.elements[2]*=l,_i.elements[4]*=u,_i.elements[5]*=u,_i.elements[6]*=u,_i.elements[8]*=h,_i.elements[9]*=h,_i.elements[10]*=h,n.setFromRotationMatrix(_i),i.x=o,i.y=a,i.z=c,this}makePerspective(t,n,i,r,s,o,a=Zn,c=!1){let l=this.elements,u=2*s/(n-t),h=2*s/(i-r),f=(n+t)/(n-t),d=(i+r)/(i-r),p,_;if(c)p=s/(o-s),_=o*s/(o-s);else if(a===Zn)p=-(o+s)/(o-s),_=-2*o*s/(o-s);else if(a===Co)p=-o/(o-s),_=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=u,l[4]=0,l[8]=f,l[12]=0,l[1]=0,l[5]=h,l[9]=d,l[13]=0,l[2]=0,l[6]=0,l[10]=p,l[14]=_,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,n,i,r,s,o,a=Zn,c=!1){let l=this.elements,u=2/(n-t),h=2/(i-r),f=-(n+t)/(n-t),d=-(i+r)/(i-r),p,_;if(c)p=1/(o-s),_=o/(o-s);else if(a===Zn)p=-2/(o-s),_=-(o+s)/(o-s);else if(a===Co)p=-1/(o-s),_=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=u,l[4]=0,l[8]=0,l[12]=f,l[1]=0,l[5]=h,l[9]=0,l[13]=d,l[2]=0,l[6]=0,l[10]=p,l[14]=_,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let n=this.elements,i=t.elements;for(let r=0;r<16;r++)if(n[r]!==i[r])return!1;return!0}fromArray(t,n=0){for(let i=0;i<16;i++)this.elements[i]=t[i+n];return this}toArray(t=[],n=0){let i=this.elements;return t[n]=i[0],t[n+1]=i[1],t[n+2]=i[2],t[n+3]=i[3],t[n+4]=i[4],t[n+5]=i[5],t[n+6]=i[6],t[n+7]=i[7],t[n+8]=i[8],t[n+9]=i[9],t[n+10]=i[10],t[n+11]=i[11],t[n+12]=i[12],t[n+13]=i[13],t[n+14]=i[14],t[n+15]=i[15],t}};Bu.prototype.isMatrix4=!0;var de=Bu,po=new V,_i=new de,m2=new V(0,0,0),g2=new V(1,1,1),Gr=new V,Fl=new V,Un=new V,ix=new de,rx=new On,mr=class e{constructor(t=0,n=0,i=0,r=e.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=n,this._z=i,this._order=r}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,n,i,r=this._order){return this._x=t,this._y=n,this._z=i,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,n=this._order,i=!0){let r=t.elements,s=r[0],o=r[4],a=r[8],c=r[1],l=r[5],u=r[9],h=r[2],f=r[6],d=r[10];switch(n){case"XYZ":this._y=Math.asin(Kt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(f,l),this._z=0);break;case"YXZ":this._x=Math.asin(-Kt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-h,s),this._z=0);break;case"ZXY":this._x=Math.asin(Kt(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,s));break;case"ZYX":this._y=Math.asin(-Kt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(c,s)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(Kt(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-u,l),this._y=Math.atan2(-h,s)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-Kt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,l),this._y=Math.atan2(a,s)):(this._x=Math.atan2(-u,d),this._y=0);break;default:Dt("Euler: .setFromRotationMatrix() encountered an unknown order: "+n)}return this._order=n,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,n,i){return ix.makeRotationFromQuaternion(t),this.setFromRotationMatrix(ix,n,i)}setFromVector3(t,n=this._order){return this.set(t.x,t.y,t.z,n)}reorder(t){return rx.setFromEuler(this),this.setFromQuaternion(rx,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],n=0){return t[n]=this._x,t[n+1]=this._y,t[n+2]=this._z,t[n+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};mr.DEFAULT_ORDER="XYZ";var Lo=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},_2=0,sx=new V,mo=new On,ar=new de,Ol=new V,Ha=new V,y2=new V,x2=new On,ox=new V(1,0,0),ax=new V(0,1,0),cx=new V(0,0,1),lx={type:"added"},v2={type:"removed"},go={type:"childadded",child:null},kd={type:"childremoved",child:null},on=class e extends vi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:_2++}),this.uuid=Ho(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=e.DEFAULT_UP.clone();let t=new V,n=new mr,i=new On,r=new V(1,1,1);function s(){i.setFromEuler(n,!1)}function o(){n.setFromQuaternion(i,void 0,!1)}n._onChange(s),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:n},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new de},normalMatrix:{value:new kt}}),this.matrix=new de,this.matrixWorld=new de,this.matrixAutoUpdate=e.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=e.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Lo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,n){this.quaternion.setFromAxisAngle(t,n)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,n){return mo.setFromAxisAngle(t,n),this.quaternion.multiply(mo),this}rotateOnWorldAxis(t,n){return mo.setFromAxisAngle(t,n),this.quaternion.premultiply(mo),this}rotateX(t){return this.rotateOnAxis(ox,t)}rotateY(t){return this.rotateOnAxis(ax,t)}rotateZ(t){return this.rotateOnAxis(cx,t)}translateOnAxis(t,n){return sx.copy(t).applyQuaternion(this.quaternion),this.position.add(sx.multiplyScalar(n)),this}translateX(t){return this.translateOnAxis(ox,t)}translateY(t){return this.translateOnAxis(ax,t)}translateZ(t){return this.translateOnAxis(cx,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ar.copy(this.matrixWorld).invert())}lookAt(t,n,i){t.isVector3?Ol.copy(t):Ol.set(t,n,i);let r=this.parent;this.updateWorldMatrix(!0,!1),Ha.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ar.lookAt(Ha,Ol,this.up):ar.lookAt(Ol,Ha,this.up),this.quaternion.setFromRotationMatrix(ar),r&&(ar.extractRotation(r.matrixWorld),mo.setFromRotationMatrix(ar),this.quaternion.premultiply(mo.invert()))}add(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.add(arguments[n]);return this}return t===this?(Ot("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(lx),go.child=t,this.dispatchEvent(go),go.child=null):Ot("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let n=this.children.indexOf(t);return n!==-1&&(t.parent=null,this.children.splice(n,1),t.dispatchEvent(v2),kd.child=t,this.dispatchEvent(kd),kd.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ar.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),ar.multiply(t.parent.matrixWorld)),t.applyMatrix4(ar),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(lx),go.child=t,this.dispatchEvent(go),go.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,n){if(this[t]===n)return this;for(let i=0,r=this.children.length;i<r;i++){let o=this.children[i].getObjectByProperty(t,n);if(o!==void 0)return o}}getObjectsByProperty(t,n,i=[]){this[t]===n&&i.push(this);let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].getObjectsByProperty(t,n,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ha,t,y2),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ha,x2,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let n=this.matrixWorld.elements;return t.set(n[8],n[9],n[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let n=this.children;for(let i=0,r=n.length;i<r;i++)n[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let n=this.children;for(let i=0,r=n.length;i<r;i++)n[i].traverseVisible(t)}traverseAncestors(t){let n=this.parent;n!==null&&(t(n),n.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let n=t.x,i=t.y,r=t.z,s=this.matrix.elements;s[12]+=n-s[0]*n-s[4]*i-s[8]*r,s[13]+=i-s[1]*n-s[5]*i-s[9]*r,s[14]+=r-s[2]*n-s[6]*i-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let n=this.children;for(let i=0,r=n.length;i<r;i++)n[i].updateMatrixWorld(t)}updateWorldMatrix(t,n,i=!1){let r=this.parent;if(t===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),n===!0){let s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let n=t===void 0||typeof t=="string",i={};n&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(a=>({...a})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(t),r.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,u=c.length;l<u;l++){let h=c[l];s(t.shapes,h)}else s(t.shapes,c)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(t.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(s(t.materials,this.material[c]));r.material=a}else r.material=s(t.materials,this.material);if(this.children.length>0){r.children=[];for(let a=0;a<this.children.length;a++)r.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){r.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];r.animations.push(s(t.animations,c))}}if(n){let a=o(t.geometries),c=o(t.materials),l=o(t.textures),u=o(t.images),h=o(t.shapes),f=o(t.skeletons),d=o(t.animations),p=o(t.nodes);a.length>0&&(i.geometries=a),c.length>0&&(i.materials=c),l.length>0&&(i.textures=l),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),d.length>0&&(i.animations=d),p.length>0&&(i.nodes=p)}return i.object=r,i;function o(a){let c=[];for(let l in a){let u=a[l];delete u.metadata,c.push(u)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,n=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),n===!0)for(let i=0;i<t.children.length;i++){let r=t.children[i];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};on.DEFAULT_UP=new V(0,1,0);on.DEFAULT_MATRIX_AUTO_UPDATE=!0;on.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var hr=class extends on{constructor(){super(),this.isGroup=!0,this.type="Group"}},b2={type:"move"},No=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new hr,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new hr,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new V,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new V),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new hr,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new V,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new V,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let n=this._hand;if(n)for(let i of t.hand.values())this._getHandJoint(n,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,n,i){let r=null,s=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(t&&n.session.visibilityState!=="visible-blurred"){if(l&&t.hand){o=!0;for(let _ of t.hand.values()){let g=n.getJointPose(_,i),m=this._getHandJoint(l,_);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let u=l.joints["index-finger-tip"],h=l.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,p=.005;l.inputState.pinching&&f>d+p?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&f<=d-p&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(s=n.getPose(t.gripSpace,i),s!==null&&(c.matrix.fromArray(s.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,s.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(s.linearVelocity)):c.hasLinearVelocity=!1,s.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(s.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(r=n.getPose(t.targetRaySpace,i),r===null&&s!==null&&(r=s),r!==null&&(a.matrix.fromArray(r.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,r.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(r.linearVelocity)):a.hasLinearVelocity=!1,r.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(r.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(b2)))}return a!==null&&(a.visible=r!==null),c!==null&&(c.visible=s!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(t,n){if(t.joints[n.jointName]===void 0){let i=new hr;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[n.jointName]=i,t.add(i)}return t.joints[n.jointName]}},dv={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Vr={h:0,s:0,l:0},Bl={h:0,s:0,l:0};function zd(e,t,n){return n<0&&(n+=1),n>1&&(n-=1),n<1/6?e+(t-e)*6*n:n<1/2?t:n<2/3?e+(t-e)*6*(2/3-n):e}var jt=class{constructor(t,n,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,n,i)}set(t,n,i){if(n===void 0&&i===void 0){let r=t;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(t,n,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,n=yn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ne.colorSpaceToWorking(this,n),this}setRGB(t,n,i,r=ne.workingColorSpace){return this.r=t,this.g=n,this.b=i,ne.colorSpaceToWorking(this,r),this}setHSL(t,n,i,r=ne.workingColorSpace){if(t=Fp(t,1),n=Kt(n,0,1),i=Kt(i,0,1),n===0)this.r=this.g=this.b=i;else{let s=i<=.5?i*(1+n):i+n-i*n,o=2*i-s;this.r=zd(o,s,t+1/3),this.g=zd(o,s,t),this.b=zd(o,s,t-1/3)}return ne.colorSpaceToWorking(this,r),this}setStyle(t,n=yn){function i(s){s!==void 0&&parseFloat(s)<1&&Dt("Color: Alpha component of "+t+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(t)){let s,o=r[1],a=r[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,n);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,n);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,n);break;default:Dt("Color: Unknown color model "+t)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(t)){let s=r[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,n);if(o===6)return this.setHex(parseInt(s,16),n);Dt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,n);return this}setColorName(t,n=yn){let i=dv[t.toLowerCase()];return i!==void 0?this.setHex(i,n):Dt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=dr(t.r),this.g=dr(t.g),this.b=dr(t.b),this}copyLinearToSRGB(t){return this.r=Ao(t.r),this.g=Ao(t.g),this.b=Ao(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=yn){return ne.workingToColorSpace(pn.copy(this),t),Math.round(Kt(pn.r*255,0,255))*65536+Math.round(Kt(pn.g*255,0,255))*256+Math.round(Kt(pn.b*255,0,255))}getHexString(t=yn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,n=ne.workingColorSpace){ne.workingToColorSpace(pn.copy(this),n);let i=pn.r,r=pn.g,s=pn.b,o=Math.max(i,r,s),a=Math.min(i,r,s),c,l,u=(a+o)/2;if(a===o)c=0,l=0;else{let h=o-a;switch(l=u<=.5?h/(o+a):h/(2-o-a),o){case i:c=(r-s)/h+(r<s?6:0);break;case r:c=(s-i)/h+2;break;case s:c=(i-r)/h+4;break}c/=6}return t.h=c,t.s=l,t.l=u,t}getRGB(t,n=ne.workingColorSpace){return ne.workingToColorSpace(pn.copy(this),n),t.r=pn.r,t.g=pn.g,t.b=pn.b,t}getStyle(t=yn){ne.workingToColorSpace(pn.copy(this),t);let n=pn.r,i=pn.g,r=pn.b;return t!==yn?`color(${t} ${n.toFixed(3)} ${i.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(n*255)},${Math.round(i*255)},${Math.round(r*255)})`}offsetHSL(t,n,i){return this.getHSL(Vr),this.setHSL(Vr.h+t,Vr.s+n,Vr.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,n){return this.r=t.r+n.r,this.g=t.g+n.g,this.b=t.b+n.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,n){return this.r+=(t.r-this.r)*n,this.g+=(t.g-this.g)*n,this.b+=(t.b-this.b)*n,this}lerpColors(t,n,i){return this.r=t.r+(n.r-t.r)*i,this.g=t.g+(n.g-t.g)*i,this.b=t.b+(n.b-t.b)*i,this}lerpHSL(t,n){this.getHSL(Vr),t.getHSL(Bl);let i=Ja(Vr.h,Bl.h,n),r=Ja(Vr.s,Bl.s,n),s=Ja(Vr.l,Bl.l,n);return this.setHSL(i,r,s),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let n=this.r,i=this.g,r=this.b,s=t.elements;return this.r=s[0]*n+s[3]*i+s[6]*r,this.g=s[1]*n+s[4]*i+s[7]*r,this.b=s[2]*n+s[5]*i+s[8]*r,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,n=0){return this.r=t[n],this.g=t[n+1],this.b=t[n+2],this}toArray(t=[],n=0){return t[n]=this.r,t[n+1]=this.g,t[n+2]=this.b,t}fromBufferAttribute(t,n){return this.r=t.getX(n),this.g=t.getY(n),this.b=t.getZ(n),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},pn=new jt;jt.NAMES=dv;var nc=class extends on{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new mr,this.environmentIntensity=1,this.environmentRotation=new mr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,n){return super.copy(t,n),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let n=super.toJSON(t);return this.fog!==null&&(n.object.fog=this.fog.toJSON()),n.object.backgroundBlurriness=this.backgroundBlurriness,n.object.backgroundIntensity=this.backgroundIntensity,n.object.backgroundRotation=this.backgroundRotation.toArray(),n.object.environmentIntensity=this.environmentIntensity,n.object.environmentRotation=this.environmentRotation.toArray(),n}},yi=new V,cr=new V,Gd=new V,lr=new V,_o=new V,yo=new V,ux=new V,Vd=new V,Hd=new V,Wd=new V,$d=new we,Xd=new we,qd=new we,Xr=class e{constructor(t=new V,n=new V,i=new V){this.a=t,this.b=n,this.c=i}static getNormal(t,n,i,r){r.subVectors(i,n),yi.subVectors(t,n),r.cross(yi);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(t,n,i,r,s){yi.subVectors(r,n),cr.subVectors(i,n),Gd.subVectors(t,n);let o=yi.dot(yi),a=yi.dot(cr),c=yi.dot(Gd),l=cr.dot(cr),u=cr.dot(Gd),h=o*l-a*a;if(h===0)return s.set(0,0,0),null;let f=1/h,d=(l*c-a*u)*f,p=(o*u-a*c)*f;return s.set(1-d-p,p,d)}static containsPoint(t,n,i,r){return this.getBarycoord(t,n,i,r,lr)===null?!1:lr.x>=0&&lr.y>=0&&lr.x+lr.y<=1}static getInterpolation(t,n,i,r,s,o,a,c){return this.getBarycoord(t,n,i,r,lr)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(s,lr.x),c.addScaledVector(o,lr.y),c.addScaledVector(a,lr.z),c)}static getInterpolatedAttribute(t,n,i,r,s,o){return $d.setScalar(0),Xd.setScalar(0),qd.setScalar(0),$d.fromBufferAttribute(t,n),Xd.fromBufferAttribute(t,i),qd.fromBufferAttribute(t,r),o.setScalar(0),o.addScaledVector($d,s.x),o.addScaledVector(Xd,s.y),o.addScaledVector(qd,s.z),o}static isFrontFacing(t,n,i,r){return yi.subVectors(i,n),cr.subVectors(t,n),yi.cross(cr).dot(r)<0}set(t,n,i){return this.a.copy(t),this.b.copy(n),this.c.copy(i),this}setFromPointsAndIndices(t,n,i,r){return this.a.copy(t[n]),this.b.copy(t[i]),this.c.copy(t[r]),this}setFromAttributeAndIndices(t,n,i,r){return this.a.fromBufferAttribute(t,n),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,r),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return yi.subVectors(this.c,this.b),cr.subVectors(this.a,this.b),yi.cross(cr).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return e.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,n){return e.getBarycoord(t,this.a,this.b,this.c,n)}getInterpolation(t,n,i,r,s){return e.getInterpolation(t,this.a,this.b,this.c,n,i,r,s)}containsPoint(t){return e.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return e.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,n){let i=this.a,r=this.b,s=this.c,o,a;_o.subVectors(r,i),yo.subVectors(s,i),Vd.subVectors(t,i);let c=_o.dot(Vd),l=yo.dot(Vd);if(c<=0&&l<=0)return n.copy(i);Hd.subVectors(t,r);let u=_o.dot(Hd),h=yo.dot(Hd);if(u>=0&&h<=u)return n.copy(r);let f=c*h-u*l;if(f<=0&&c>=0&&u<=0&&c-u>0)return o=c/(c-u),n.copy(i).addScaledVector(_o,o);Wd.subVectors(t,s);let d=_o.dot(Wd),p=yo.dot(Wd);if(p>=0&&d<=p)return n.copy(s);let _=d*l-c*p;if(_<=0&&l>=0&&p<=0)return a=l/(l-p),n.copy(i).addScaledVector(yo,a);let g=u*p-d*h;if(g<=0&&h-u>=0&&d-p>=0)return ux.subVectors(s,r),a=(h-u)/(h-u+(d-p)),n.copy(r).addScaledVector(ux,a);let m=1/(g+_+f);return o=_*m,a=f*m,n.copy(i).addScaledVector(_o,o).addScaledVector(yo,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},qr=class{constructor(t=new V(1/0,1/0,1/0),n=new V(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=n}set(t,n){return this.min.copy(t),this.max.copy(n),this}setFromArray(t){this.makeEmpty();for(let n=0,i=t.length;n<i;n+=3)this.expandByPoint(xi.fromArray(t,n));return this}setFromBufferAttribute(t){this.makeEmpty();for(let n=0,i=t.count;n<i;n++)this.expandByPoint(xi.fromBufferAttribute(t,n));return this}setFromPoints(t){this.makeEmpty();for(let n=0,i=t.length;n<i;n++)this.expandByPoint(t[n]);return this}setFromCenterAndSize(t,n){let i=xi.copy(n).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,n=!1){return this.makeEmpty(),this.expandByObject(t,n)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,n=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let s=i.getAttribute("position");if(n===!0&&s!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=s.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,xi):xi.fromBufferAttribute(s,o),xi.applyMatrix4(t.matrixWorld),this.expandByPoint(xi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),kl.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),kl.copy(i.boundingBox)),kl.applyMatrix4(t.matrixWorld),this.union(kl)}let r=t.children;for(let s=0,o=r.length;s<o;s++)this.expandByObject(r[s],n);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,n){return n.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,xi),xi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let n,i;return t.normal.x>0?(n=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(n=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(n+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(n+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(n+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(n+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),n<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Wa),zl.subVectors(this.max,Wa),xo.subVectors(t.a,Wa),vo.subVectors(t.b,Wa),bo.subVectors(t.c,Wa),Hr.subVectors(vo,xo),Wr.subVectors(bo,vo),Ts.subVectors(xo,bo);let n=[0,-Hr.z,Hr.y,0,-Wr.z,Wr.y,0,-Ts.z,Ts.y,Hr.z,0,-Hr.x,Wr.z,0,-Wr.x,Ts.z,0,-Ts.x,-Hr.y,Hr.x,0,-Wr.y,Wr.x,0,-Ts.y,Ts.x,0];return!Yd(n,xo,vo,bo,zl)||(n=[1,0,0,0,1,0,0,0,1],!Yd(n,xo,vo,bo,zl))?!1:(Gl.crossVectors(Hr,Wr),n=[Gl.x,Gl.y,Gl.z],Yd(n,xo,vo,bo,zl))}clampPoint(t,n){return n.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,xi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(xi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(ur[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),ur[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),ur[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),ur[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),ur[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),ur[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),ur[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),ur[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(ur),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},ur=[new V,new V,new V,new V,new V,new V,new V,new V],xi=new V,kl=new qr,xo=new V,vo=new V,bo=new V,Hr=new V,Wr=new V,Ts=new V,Wa=new V,zl=new V,Gl=new V,As=new V;function Yd(e,t,n,i,r){for(let s=0,o=e.length-3;s<=o;s+=3){As.fromArray(e,s);let a=r.x*Math.abs(As.x)+r.y*Math.abs(As.y)+r.z*Math.abs(As.z),c=t.dot(As),l=n.dot(As),u=i.dot(As);if(Math.max(-Math.max(c,l,u),Math.min(c,l,u))>a)return!1}return!0}var De=new V,Vl=new Ft,M2=0,Jn=class extends vi{constructor(t,n,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:M2++}),this.name="",this.array=t,this.itemSize=n,this.count=t!==void 0?t.length/n:0,this.normalized=i,this.usage=ov,this.updateRanges=[],this.gpuType=Mi,this.version=0,this._normalizationScale=t!==void 0?Bp(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,n){this.updateRanges.push({start:t,count:n})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,n,i){t*=this.itemSize,i*=n.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[t+r]=n.array[i+r];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let n=0,i=this.count;n<i;n++)Vl.fromBufferAttribute(this,n),Vl.applyMatrix3(t),this.setXY(n,Vl.x,Vl.y);else if(this.itemSize===3)for(let n=0,i=this.count;n<i;n++)De.fromBufferAttribute(this,n),De.applyMatrix3(t),this.setXYZ(n,De.x,De.y,De.z);return this}applyMatrix4(t){for(let n=0,i=this.count;n<i;n++)De.fromBufferAttribute(this,n),De.applyMatrix4(t),this.setXYZ(n,De.x,De.y,De.z);return this}applyNormalMatrix(t){for(let n=0,i=this.count;n<i;n++)De.fromBufferAttribute(this,n),De.applyNormalMatrix(t),this.setXYZ(n,De.x,De.y,De.z);return this}transformDirection(t){for(let n=0,i=this.count;n<i;n++)De.fromBufferAttribute(this,n),De.transformDirection(t),this.setXYZ(n,De.x,De.y,De.z);return this}set(t,n=0){return this.array.set(t,n),this}getComponent(t,n){let i=this.array[t*this.itemSize+n];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,n,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+n]=i,this}getX(t){let n=this.array[t*this.itemSize];return this.normalized&&(n=this._denormalize(n)),n}setX(t,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize]=n,this}getY(t){let n=this.array[t*this.itemSize+1];return this.normalized&&(n=this._denormalize(n)),n}setY(t,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+1]=n,this}getZ(t){let n=this.array[t*this.itemSize+2];return this.normalized&&(n=this._denormalize(n)),n}setZ(t,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+2]=n,this}getW(t){let n=this.array[t*this.itemSize+3];return this.normalized&&(n=this._denormalize(n)),n}setW(t,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+3]=n,this}setXY(t,n,i){return t*=this.itemSize,this.normalized&&(n=this._normalize(n),i=this._normalize(i)),this.array[t+0]=n,this.array[t+1]=i,this}setXYZ(t,n,i,r){return t*=this.itemSize,this.normalized&&(n=this._normalize(n),i=this._normalize(i),r=this._normalize(r)),this.array[t+0]=n,this.array[t+1]=i,this.array[t+2]=r,this}setXYZW(t,n,i,r,s){return t*=this.itemSize,this.normalized&&(n=this._normalize(n),i=this._normalize(i),r=this._normalize(r),s=this._normalize(s)),this.array[t+0]=n,this.array[t+1]=i,this.array[t+2]=r,this.array[t+3]=s,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let n=this._normalizationScale;return n!==void 0?Math.max(t/n,-1):fv(t,this.array)}_normalize(t){let n=this._normalizationScale;return n!==void 0?Math.round(t*n):hv(t,this.array)}};var ic=class extends Jn{constructor(t,n,i){super(new Uint16Array(t),n,i)}};var rc=class extends Jn{constructor(t,n,i){super(new Uint32Array(t),n,i)}};var rn=class extends Jn{constructor(t,n,i){super(new Float32Array(t),n,i)}},S2=new qr,$a=new V,Zd=new V,Rs=class{constructor(t=new V,n=-1){this.isSphere=!0,this.center=t,this.radius=n}set(t,n){return this.center.copy(t),this.radius=n,this}setFromPoints(t,n){let i=this.center;n!==void 0?i.copy(n):S2.setFromPoints(t).getCenter(i);let r=0;for(let s=0,o=t.length;s<o;s++)r=Math.max(r,i.distanceToSquared(t[s]));return this.radius=Math.sqrt(r),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let n=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=n*n}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,n){let i=this.center.distanceToSquared(t);return n.copy(t),i>this.radius*this.radius&&(n.sub(this.center).normalize(),n.multiplyScalar(this.radius).add(this.center)),n}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;$a.subVectors(t,this.center);let n=$a.lengthSq();if(n>this.radius*this.radius){let i=Math.sqrt(n),r=(i-this.radius)*.5;this.center.addScaledVector($a,r/i),this.radius+=r}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Zd.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint($a.copy(t.center).add(Zd)),this.expandByPoint($a.copy(t.center).sub(Zd))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},w2=0,Yn=new de,Jd=new on,Mo=new V,Fn=new qr,Xa=new qr,qe=new V,Kn=class e extends vi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:w2++}),this.uuid=Ho(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(ZE(t)?rc:ic)(t,1):this.index=t,this}setIndirect(t,n=0){return this.indirect=t,this.indirectOffset=n,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,n){return this.attributes[t]=n,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,n,i=0){this.groups.push({start:t,count:n,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,n){this.drawRange.start=t,this.drawRange.count=n}applyMatrix4(t){let n=this.attributes.position;n!==void 0&&(n.applyMatrix4(t),n.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let s=new kt().getNormalMatrix(t);i.applyNormalMatrix(s),i.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(t),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Yn.makeRotationFromQuaternion(t),this.applyMatrix4(Yn),this}rotateX(t){return Yn.makeRotationX(t),this.applyMatrix4(Yn),this}rotateY(t){return Yn.makeRotationY(t),this.applyMatrix4(Yn),this}rotateZ(t){return Yn.makeRotationZ(t),this.applyMatrix4(Yn),this}translate(t,n,i){return Yn.makeTranslation(t,n,i),this.applyMatrix4(Yn),this}scale(t,n,i){return Yn.makeScale(t,n,i),this.applyMatrix4(Yn),this}lookAt(t){return Jd.lookAt(t),Jd.updateMatrix(),this.applyMatrix4(Jd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Mo).negate(),this.translate(Mo.x,Mo.y,Mo.z),this}setFromPoints(t){let n=this.getAttribute("position");if(n===void 0){let i=[];for(let r=0,s=t.length;r<s;r++){let o=t[r];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new rn(i,3))}else{let i=Math.min(t.length,n.count);for(let r=0;r<i;r++){let s=t[r];n.setXYZ(r,s.x,s.y,s.z||0)}t.length>n.count&&Dt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),n.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new qr);let t=this.attributes.position,n=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Ot("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new V(-1/0,-1/0,-1/0),new V(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),n)for(let i=0,r=n.length;i<r;i++){let s=n[i];Fn.setFromBufferAttribute(s),this.morphTargetsRelative?(qe.addVectors(this.boundingBox.min,Fn.min),this.boundingBox.expandByPoint(qe),qe.addVectors(this.boundingBox.max,Fn.max),this.boundingBox.expandByPoint(qe)):(this.boundingBox.expandByPoint(Fn.min),this.boundingBox.expandByPoint(Fn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ot('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Rs);let t=this.attributes.position,n=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Ot("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new V,1/0);return}if(t){let i=this.boundingSphere.center;if(Fn.setFromBufferAttribute(t),n)for(let s=0,o=n.length;s<o;s++){let a=n[s];Xa.setFromBufferAttribute(a),this.morphTargetsRelative?(qe.addVectors(Fn.min,Xa.min),Fn.expandByPoint(qe),qe.addVectors(Fn.max,Xa.max),Fn.expandByPoint(qe)):(Fn.expandByPoint(Xa.min),Fn.expandByPoint(Xa.max))}Fn.getCenter(i);let r=0;for(let s=0,o=t.count;s<o;s++)qe.fromBufferAttribute(t,s),r=Math.max(r,i.distanceToSquared(qe));if(n)for(let s=0,o=n.length;s<o;s++){let a=n[s],c=this.morphTargetsRelative;for(let l=0,u=a.count;l<u;l++)qe.fromBufferAttribute(a,l),c&&(Mo.fromBufferAttribute(t,l),qe.add(Mo)),r=Math.max(r,i.distanceToSquared(qe))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&Ot('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,n=this.attributes;if(t===null||n.position===void 0||n.normal===void 0||n.uv===void 0){Ot("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=n.position,r=n.normal,s=n.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Jn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(i.count);for(let R=0;R<i.count;R++)a[R]=new V,c[R]=new V;let u=new V,h=new V,f=new V,d=new Ft,p=new Ft,_=new Ft,g=new V,m=new V;function x(R,C,E){l[R]=l[C]=l[E]=1,u.fromBufferAttribute(i,R),h.fromBufferAttribute(i,C),f.fromBufferAttribute(i,E),d.fromBufferAttribute(s,R),p.fromBufferAttribute(s,C),_.fromBufferAttribute(s,E),h.sub(u),f.sub(u),p.sub(d),_.sub(d);let N=1/(p.x*_.y-_.x*p.y);isFinite(N)&&(g.copy(h).multiplyScalar(_.y).addScaledVector(f,-p.y).multiplyScalar(N),m.copy(f).multiplyScalar(p.x).addScaledVector(h,-_.x).multiplyScalar(N),a[R].add(g),a[C].add(g),a[E].add(g),c[R].add(m),c[C].add(m),c[E].add(m))}let S=this.groups;S.length===0&&(S=[{start:0,count:t.count}]);for(let R=0,C=S.length;R<C;++R){let E=S[R],N=E.start,k=E.count;for(let P=N,L=N+k;P<L;P+=3)x(t.getX(P+0),t.getX(P+1),t.getX(P+2))}let v=new V,w=new V,b=new V,y=new V;function M(R){b.fromBufferAttribute(r,R),y.copy(b);let C=a[R];v.copy(C),v.sub(b.multiplyScalar(b.dot(C))).normalize(),w.crossVectors(y,C);let N=w.dot(c[R])<0?-1:1;o.setXYZW(R,v.x,v.y,v.z,N)}for(let R=0,C=i.count;R<C;++R)l[R]&&M(R);this._transformed=!0}computeVertexNormals(){let t=this.index,n=this.getAttribute("position");if(n!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==n.count)i=new Jn(new Float32Array(n.count*3),3),this.setAttribute("normal",i);else for(let f=0,d=i.count;f<d;f++)i.setXYZ(f,0,0,0);let r=new V,s=new V,o=new V,a=new V,c=new V,l=new V,u=new V,h=new V;if(t)for(let f=0,d=t.count;f<d;f+=3){let p=t.getX(f+0),_=t.getX(f+1),g=t.getX(f+2);r.fromBufferAttribute(n,p),s.fromBufferAttribute(n,_),o.fromBufferAttribute(n,g),u.subVectors(o,s),h.subVectors(r,s),u.cross(h),a.fromBufferAttribute(i,p),c.fromBufferAttribute(i,_),l.fromBufferAttribute(i,g),a.add(u),c.add(u),l.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(_,c.x,c.y,c.z),i.setXYZ(g,l.x,l.y,l.z)}else for(let f=0,d=n.count;f<d;f+=3)r.fromBufferAttribute(n,f+0),s.fromBufferAttribute(n,f+1),o.fromBufferAttribute(n,f+2),u.subVectors(o,s),h.subVectors(r,s),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let n=0,i=t.count;n<i;n++)qe.fromBufferAttribute(t,n),qe.normalize(),t.setXYZ(n,qe.x,qe.y,qe.z)}toNonIndexed(){function t(a,c){let l=a.array,u=a.itemSize,h=a.normalized,f=new l.constructor(c.length*u),d=0,p=0;for(let _=0,g=c.length;_<g;_++){a.isInterleavedBufferAttribute?d=c[_]*a.data.stride+a.offset:d=c[_]*u;for(let m=0;m<u;m++)f[p++]=l[d++]}return new Jn(f,u,h)}if(this.index===null)return Dt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let n=new e,i=this.index.array,r=this.attributes;for(let a in r){let c=r[a],l=t(c,i);n.setAttribute(a,l)}let s=this.morphAttributes;for(let a in s){let c=[],l=s[a];for(let u=0,h=l.length;u<h;u++){let f=l[u],d=t(f,i);c.push(d)}n.morphAttributes[a]=c}n.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];n.addGroup(l.start,l.count,l.materialIndex)}return n}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let n=this.index;n!==null&&(t.data.index={type:n.array.constructor.name,array:Array.prototype.slice.call(n.array)});let i=this.attributes;for(let c in i){let l=i[c];t.data.attributes[c]=l.toJSON(t.data)}let r={},s=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],u=[];for(let h=0,f=l.length;h<f;h++){let d=l[h];u.push(d.toJSON(t.data))}u.length>0&&(r[c]=u,s=!0)}s&&(t.data.morphAttributes=r,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let n={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let r=t.attributes;for(let l in r){let u=r[l];this.setAttribute(l,u.clone(n))}let s=t.morphAttributes;for(let l in s){let u=[],h=s[l];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(n));this.morphAttributes[l]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let l=0,u=o.length;l<u;l++){let h=o[l];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Kd=new V,T2=new V,A2=new kt,xn=class{constructor(t=new V(1,0,0),n=0){this.isPlane=!0,this.normal=t,this.constant=n}set(t,n){return this.normal.copy(t),this.constant=n,this}setComponents(t,n,i,r){return this.normal.set(t,n,i),this.constant=r,this}setFromNormalAndCoplanarPoint(t,n){return this.normal.copy(t),this.constant=-n.dot(this.normal),this}setFromCoplanarPoints(t,n,i){let r=Kd.subVectors(i,n).cross(T2.subVectors(t,n)).normalize();return this.setFromNormalAndCoplanarPoint(r,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,n){return n.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,n,i=!0){let r=t.delta(Kd),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(t.start)===0?n.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/s;return i===!0&&(o<0||o>1)?null:n.copy(t.start).addScaledVector(r,o)}intersectsLine(t){let n=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return n<0&&i>0||i<0&&n>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,n){let i=n||A2.getNormalMatrix(t),r=this.coplanarPoint(Kd).applyMatrix4(t),s=this.normal.applyMatrix3(i).normalize();return this.constant=-r.dot(s),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},E2=0,gr=class extends vi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:E2++}),this.uuid=Ho(),this.name="",this.type="Material",this.blending=zo,this.side=Di,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=pp,this.blendDst=mp,this.blendEquation=Is,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new jt(0,0,0),this.blendAlpha=0,this.depthFunc=Eo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=tv,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=su,this.stencilZFail=su,this.stencilZPass=su,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let n in t){let i=t[n];if(i===void 0){Dt(`Material: parameter '${n}' has value of undefined.`);continue}let r=this[n];if(r===void 0){Dt(`Material: '${n}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(i):r&&r.isVector2&&i&&i.isVector2||r&&r.isEuler&&i&&i.isEuler||r&&r.isVector3&&i&&i.isVector3?r.copy(i):this[n]=i}}toJSON(t){let n=t===void 0||typeof t=="string";n&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function r(s){let o=[];for(let a in s){let c=s[a];delete c.metadata,o.push(c)}return o}if(n){let s=r(t.textures),o=r(t.images);s.length>0&&(i.textures=s),o.length>0&&(i.images=o)}return i}fromJSON(t,n){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new jt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new xn().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=n[t.map]||null),t.matcap!==void 0&&(this.matcap=n[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=n[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=n[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=n[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Ft().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=n[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=n[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=n[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=n[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=n[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=n[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=n[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=n[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=n[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=n[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=n[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=n[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=n[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=n[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ft().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=n[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=n[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=n[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=n[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=n[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=n[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=n[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=n[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let n=t.clippingPlanes,i=null;if(n!==null){let r=n.length;i=new Array(r);for(let s=0;s!==r;++s)i[s]=n[s].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var fr=new V,jd=new V,Hl=new V,Wl=new V,Yr=class{constructor(t=new V,n=new V(0,0,-1)){this.origin=t,this.direction=n}set(t,n){return this.origin.copy(t),this.direction.copy(n),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,n){return n.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,fr)),this}closestPointToPoint(t,n){n.subVectors(t,this.origin);let i=n.dot(this.direction);return i<0?n.copy(this.origin):n.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let n=fr.subVectors(t,this.origin).dot(this.direction);return n<0?this.origin.distanceToSquared(t):(fr.copy(this.origin).addScaledVector(this.direction,n),fr.distanceToSquared(t))}distanceSqToSegment(t,n,i,r){jd.copy(t).add(n).multiplyScalar(.5),Hl.copy(n).sub(t).normalize(),Wl.copy(this.origin).sub(jd);let s=t.distanceTo(n)*.5,o=-this.direction.dot(Hl),a=Wl.dot(this.direction),c=-Wl.dot(Hl),l=Wl.lengthSq(),u=Math.abs(1-o*o),h,f,d,p;if(u>0)if(h=o*c-a,f=o*a-c,p=s*u,h>=0)if(f>=-p)if(f<=p){let _=1/u;h*=_,f*=_,d=h*(h+o*f+2*a)+f*(o*h+f+2*c)+l}else f=s,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*c)+l;else f=-s,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*c)+l;else f<=-p?(h=Math.max(0,-(-o*s+a)),f=h>0?-s:Math.min(Math.max(-s,-c),s),d=-h*h+f*(f+2*c)+l):f<=p?(h=0,f=Math.min(Math.max(-s,-c),s),d=f*(f+2*c)+l):(h=Math.max(0,-(o*s+a)),f=h>0?s:Math.min(Math.max(-s,-c),s),d=-h*h+f*(f+2*c)+l);else f=o>0?-s:s,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*c)+l;return i&&i.copy(this.origin).addScaledVector(this.direction,h),r&&r.copy(jd).addScaledVector(Hl,f),d}intersectSphere(t,n){if(t.radius<0)return null;fr.subVectors(t.center,this.origin);let i=fr.dot(this.direction),r=fr.dot(fr)-i*i,s=t.radius*t.radius;if(r>s)return null;let o=Math.sqrt(s-r),a=i-o,c=i+o;return c<0?null:a<0?this.at(c,n):this.at(a,n)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let n=t.normal.dot(this.direction);if(n===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/n;return i>=0?i:null}intersectPlane(t,n){let i=this.distanceToPlane(t);return i===null?null:this.at(i,n)}intersectsPlane(t){let n=t.distanceToPoint(this.origin);return n===0||t.normal.dot(this.direction)*n<0}intersectBox(t,n){let i,r,s,o,a,c,l=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return l>=0?(i=(t.min.x-f.x)*l,r=(t.max.x-f.x)*l):(i=(t.max.x-f.x)*l,r=(t.min.x-f.x)*l),u>=0?(s=(t.min.y-f.y)*u,o=(t.max.y-f.y)*u):(s=(t.max.y-f.y)*u,o=(t.min.y-f.y)*u),i>o||s>r||((s>i||isNaN(i))&&(i=s),(o<r||isNaN(r))&&(r=o),h>=0?(a=(t.min.z-f.z)*h,c=(t.max.z-f.z)*h):(a=(t.max.z-f.z)*h,c=(t.min.z-f.z)*h),i>c||a>r)||((a>i||i!==i)&&(i=a),(c<r||r!==r)&&(r=c),r<0)?null:this.at(i>=0?i:r,n)}intersectsBox(t){return this.intersectBox(t,fr)!==null}intersectTriangle(t,n,i,r,s){let o=this.origin,a=this.direction,c=a.x,l=a.y,u=a.z,h=t.x-o.x,f=t.y-o.y,d=t.z-o.z,p=n.x-o.x,_=n.y-o.y,g=n.z-o.z,m=i.x-o.x,x=i.y-o.y,S=i.z-o.z,v=Math.abs(c),w=Math.abs(l),b=Math.abs(u),y,M,R,C,E,N,k,P,L,B,U,Z;if(v>=w&&v>=b?(R=c,N=h,L=p,Z=m,c>=0?(y=l,M=u,C=f,E=d,k=_,P=g,B=x,U=S):(y=u,M=l,C=d,E=f,k=g,P=_,B=S,U=x)):w>=b?(R=l,N=f,L=_,Z=x,l>=0?(y=u,M=c,C=d,E=h,k=g,P=p,B=S,U=m):(y=c,M=u,C=h,E=d,k=p,P=g,B=m,U=S)):(R=u,N=d,L=g,Z=S,u>=0?(y=c,M=l,C=h,E=f,k=p,P=_,B=m,U=x):(y=l,M=c,C=f,E=h,k=_,P=p,B=x,U=m)),R===0)return null;let F=y/R,G=M/R,q=1/R,rt=C-F*N,ct=E-G*N,$=k-F*L,ot=P-G*L,ut=B-F*Z,st=U-G*Z,at=ut*ot-st*$,J=rt*st-ct*ut,yt=$*ct-ot*rt;if(r){if(at<0||J<0||yt<0)return null}else if((at<0||J<0||yt<0)&&(at>0||J>0||yt>0))return null;let lt=at+J+yt;if(lt===0)return null;let K=q*(at*N+J*L+yt*Z);return(lt>0?K<0:K>0)?null:this.at(K/lt,s)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Do=class extends gr{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new jt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new mr,this.combine=ku,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},fx=new de,Es=new Yr,$l=new Rs,hx=new V,Xl=new V,ql=new V,Yl=new V,Qd=new V,Zl=new V,dx=new V,Jl=new V,jn=class extends on{constructor(t=new Kn,n=new Do){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=n,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,n){return super.copy(t,n),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let n=this.geometry.morphAttributes,i=Object.keys(n);if(i.length>0){let r=n[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}getVertexPosition(t,n){let i=this.geometry,r=i.attributes.position,s=i.morphAttributes.position,o=i.morphTargetsRelative;n.fromBufferAttribute(r,t);let a=this.morphTargetInfluences;if(s&&a){Zl.set(0,0,0);for(let c=0,l=s.length;c<l;c++){let u=a[c],h=s[c];u!==0&&(Qd.fromBufferAttribute(h,t),o?Zl.addScaledVector(Qd,u):Zl.addScaledVector(Qd.sub(n),u))}n.add(Zl)}return n}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,n){let i=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),$l.copy(i.boundingSphere),$l.applyMatrix4(s),Es.copy(t.ray).recast(t.near),!($l.containsPoint(Es.origin)===!1&&(Es.intersectSphere($l,hx)===null||Es.origin.distanceToSquared(hx)>(t.far-t.near)**2))&&(fx.copy(s).invert(),Es.copy(t.ray).applyMatrix4(fx),!(i.boundingBox!==null&&Es.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,n,Es)))}_computeIntersections(t,n,i){let r,s=this.geometry,o=this.material,a=s.index,c=s.attributes.position,l=s.attributes.uv,u=s.attributes.uv1,h=s.attributes.normal,f=s.groups,d=s.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,_=f.length;p<_;p++){let g=f[p],m=o[g.materialIndex],x=Math.max(g.start,d.start),S=Math.min(a.count,Math.min(g.start+g.count,d.start+d.count));for(let v=x,w=S;v<w;v+=3){let b=a.getX(v),y=a.getX(v+1),M=a.getX(v+2);r=Kl(this,m,t,i,l,u,h,b,y,M),r&&(r.faceIndex=Math.floor(v/3),r.face.materialIndex=g.materialIndex,n.push(r))}}else{let p=Math.max(0,d.start),_=Math.min(a.count,d.start+d.count);for(let g=p,m=_;g<m;g+=3){let x=a.getX(g),S=a.getX(g+1),v=a.getX(g+2);r=Kl(this,o,t,i,l,u,h,x,S,v),r&&(r.faceIndex=Math.floor(g/3),n.push(r))}}else if(c!==void 0)if(Array.isArray(o))for(let p=0,_=f.length;p<_;p++){let g=f[p],m=o[g.materialIndex],x=Math.max(g.start,d.start),S=Math.min(c.count,Math.min(g.start+g.count,d.start+d.count));for(let v=x,w=S;v<w;v+=3){let b=v,y=v+1,M=v+2;r=Kl(this,m,t,i,l,u,h,b,y,M),r&&(r.faceIndex=Math.floor(v/3),r.face.materialIndex=g.materialIndex,n.push(r))}}else{let p=Math.max(0,d.start),_=Math.min(c.count,d.start+d.count);for(let g=p,m=_;g<m;g+=3){let x=g,S=g+1,v=g+2;r=Kl(this,o,t,i,l,u,h,x,S,v),r&&(r.faceIndex=Math.floor(g/3),n.push(r))}}}};function C2(e,t,n,i,r,s,o,a){let c;if(t.side===an?c=i.intersectTriangle(o,s,r,!0,a):c=i.intersectTriangle(r,s,o,t.side===Di,a),c===null)return null;Jl.copy(a),Jl.applyMatrix4(e.matrixWorld);let l=n.ray.origin.distanceTo(Jl);return l<n.near||l>n.far?null:{distance:l,point:Jl.clone(),object:e}}function Kl(e,t,n,i,r,s,o,a,c,l){e.getVertexPosition(a,Xl),e.getVertexPosition(c,ql),e.getVertexPosition(l,Yl);let u=C2(e,t,n,i,Xl,ql,Yl,dx);if(u){let h=new V;Xr.getBarycoord(dx,Xl,ql,Yl,h),r&&(u.uv=Xr.getInterpolatedAttribute(r,a,c,l,h,new Ft)),s&&(u.uv1=Xr.getInterpolatedAttribute(s,a,c,l,h,new Ft)),o&&(u.normal=Xr.getInterpolatedAttribute(o,a,c,l,h,new V),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:c,c:l,normal:new V,materialIndex:0};Xr.getNormal(Xl,ql,Yl,f.normal),u.face=f,u.barycoord=h}return u}var Uo=class extends An{constructor(t=null,n=1,i=1,r,s,o,a,c,l=Ye,u=Ye,h,f){super(null,o,a,c,l,u,r,s,h,f),this.isDataTexture=!0,this.image={data:t,width:n,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Cs=new Rs,R2=new Ft(.5,.5),jl=new V,Zr=class{constructor(t=new xn,n=new xn,i=new xn,r=new xn,s=new xn,o=new xn){this.planes=[t,n,i,r,s,o]}set(t,n,i,r,s,o){let a=this.planes;return a[0].copy(t),a[1].copy(n),a[2].copy(i),a[3].copy(r),a[4].copy(s),a[5].copy(o),this}copy(t){let n=this.planes;for(let i=0;i<6;i++)n[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,n=Zn,i=!1){let r=this.planes,s=t.elements,o=s[0],a=s[1],c=s[2],l=s[3],u=s[4],h=s[5],f=s[6],d=s[7],p=s[8],_=s[9],g=s[10],m=s[11],x=s[12],S=s[13],v=s[14],w=s[15];if(r[0].setComponents(l-o,d-u,m-p,w-x).normalize(),r[1].setComponents(l+o,d+u,m+p,w+x).normalize(),r[2].setComponents(l+a,d+h,m+_,w+S).normalize(),r[3].setComponents(l-a,d-h,m-_,w-S).normalize(),i)r[4].setComponents(c,f,g,v).normalize(),r[5].setComponents(l-c,d-f,m-g,w-v).normalize();else if(r[4].setComponents(l-c,d-f,m-g,w-v).normalize(),n===Zn)r[5].setComponents(l+c,d+f,m+g,w+v).normalize();else if(n===Co)r[5].setComponents(c,f,g,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+n);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Cs.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let n=t.geometry;n.boundingSphere===null&&n.computeBoundingSphere(),Cs.copy(n.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Cs)}intersectsSprite(t){Cs.center.set(0,0,0);let n=R2.distanceTo(t.center);return Cs.radius=.7071067811865476+n,Cs.applyMatrix4(t.matrixWorld),this.intersectsSphere(Cs)}intersectsSphere(t){let n=this.planes,i=t.center,r=-t.radius;for(let s=0;s<6;s++)if(n[s].distanceToPoint(i)<r)return!1;return!0}intersectsBox(t){let n=this.planes;for(let i=0;i<6;i++){let r=n[i];if(jl.x=r.normal.x>0?t.max.x:t.min.x,jl.y=r.normal.y>0?t.max.y:t.min.y,jl.z=r.normal.z>0?t.max.z:t.min.z,r.distanceToPoint(jl)<0)return!1}return!0}containsPoint(t){let n=this.planes;for(let i=0;i<6;i++)if(n[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},px=new de,xu=class e{constructor(){this.coordinateSystem=Zn,this._frustums=[],this._count=0}setFromArrayCamera(t){let n=t.cameras,i=this._frustums;for(let r=0;r<n.length;r++){let s=n[r];px.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),i[r]===void 0&&(i[r]=new Zr),i[r].setFromProjectionMatrix(px,s.coordinateSystem,s.reversedDepth)}return this._count=n.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let n=this._frustums;for(let i=0;i<this._count;i++)if(n[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let n=this._frustums;for(let i=0;i<this._count;i++)if(n[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let n=this._frustums;for(let i=0;i<this._count;i++)if(n[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let n=this._frustums;for(let i=0;i<this._count;i++)if(n[i].intersectsBox(t))return!0;return!1}containsPoint(t){let n=this._frustums;for(let i=0;i<this._count;i++)if(n[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let n=this._frustums,i=t._frustums;for(let r=0;r<t._count;r++)n[r]===void 0&&(n[r]=new Zr),n[r].copy(i[r]);return this._count=t._count,this}clone(){return new e().copy(this)}};var Fo=class extends gr{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new jt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},vu=new V,bu=new V,mx=new de,qa=new Yr,Ql=new Rs,tp=new V,gx=new V,Mu=class extends on{constructor(t=new Kn,n=new Fo){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=n,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,n){return super.copy(t,n),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let n=t.attributes.position,i=[0];for(let r=1,s=n.count;r<s;r++)vu.fromBufferAttribute(n,r-1),bu.fromBufferAttribute(n,r),i[r]=i[r-1],i[r]+=vu.distanceTo(bu);t.setAttribute("lineDistance",new rn(i,1))}else Dt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,n){let i=this.geometry,r=this.matrixWorld,s=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Ql.copy(i.boundingSphere),Ql.applyMatrix4(r),Ql.radius+=s,t.ray.intersectsSphere(Ql)===!1)return;mx.copy(r).invert(),qa.copy(t.ray).applyMatrix4(mx);let a=s/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,u=i.index,f=i.attributes.position;if(u!==null){let d=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let _=d,g=p-1;_<g;_+=l){let m=u.getX(_),x=u.getX(_+1),S=tu(this,t,qa,c,m,x,_);S&&n.push(S)}if(this.isLineLoop){let _=u.getX(p-1),g=u.getX(d),m=tu(this,t,qa,c,_,g,p-1);m&&n.push(m)}}else{let d=Math.max(0,o.start),p=Math.min(f.count,o.start+o.count);for(let _=d,g=p-1;_<g;_+=l){let m=tu(this,t,qa,c,_,_+1,_);m&&n.push(m)}if(this.isLineLoop){let _=tu(this,t,qa,c,p-1,d,p-1);_&&n.push(_)}}}updateMorphTargets(){let n=this.geometry.morphAttributes,i=Object.keys(n);if(i.length>0){let r=n[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}};function tu(e,t,n,i,r,s,o){let a=e.geometry.attributes.position;if(vu.fromBufferAttribute(a,r),bu.fromBufferAttribute(a,s),n.distanceSqToSegment(vu,bu,tp,gx)>i)return;tp.applyMatrix4(e.matrixWorld);let l=t.ray.origin.distanceTo(tp);if(!(l<t.near||l>t.far))return{distance:l,point:gx.clone().applyMatrix4(e.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:e}}var _x=new V,yx=new V,sc=class extends Mu{constructor(t,n){super(t,n),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let n=t.attributes.position,i=[];for(let r=0,s=n.count;r<s;r+=2)_x.fromBufferAttribute(n,r),yx.fromBufferAttribute(n,r+1),i[r]=r===0?0:i[r-1],i[r+1]=i[r]+_x.distanceTo(yx);t.setAttribute("lineDistance",new rn(i,1))}else Dt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var oc=class extends An{constructor(t=[],n=Ls,i,r,s,o,a,c,l,u){super(t,n,i,r,s,o,a,c,l,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var _r=class extends An{constructor(t,n,i=bi,r,s,o,a=Ye,c=Ye,l,u=pr,h=1){if(u!==pr&&u!==xr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:t,height:n,depth:h};super(f,r,s,o,a,c,u,i,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Io(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let n=super.toJSON(t);return n.compareFunction=this.compareFunction,n}},ac=class extends _r{constructor(t,n=bi,i=Ls,r,s,o=Ye,a=Ye,c,l=pr){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,n,i,r,s,o,a,c,l),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},cc=class extends An{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Oo=class e extends Kn{constructor(t=1,n=1,i=1,r=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:n,depth:i,widthSegments:r,heightSegments:s,depthSegments:o};let a=this;r=Math.floor(r),s=Math.floor(s),o=Math.floor(o);let c=[],l=[],u=[],h=[],f=0,d=0;p("z","y","x",-1,-1,i,n,t,o,s,0),p("z","y","x",1,-1,i,n,-t,o,s,1),p("x","z","y",1,1,t,i,n,r,o,2),p("x","z","y",1,-1,t,i,-n,r,o,3),p("x","y","z",1,-1,t,n,i,r,s,4),p("x","y","z",-1,-1,t,n,-i,r,s,5),this.setIndex(c),this.setAttribute("position",new rn(l,3)),this.setAttribute("normal",new rn(u,3)),this.setAttribute("uv",new rn(h,2));function p(_,g,m,x,S,v,w,b,y,M,R){let C=v/y,E=w/M,N=v/2,k=w/2,P=b/2,L=y+1,B=M+1,U=0,Z=0,F=new V;for(let G=0;G<B;G++){let q=G*E-k;for(let rt=0;rt<L;rt++){let ct=rt*C-N;F[_]=ct*x,F[g]=q*S,F[m]=P,l.push(F.x,F.y,F.z),F[_]=0,F[g]=0,F[m]=b>0?1:-1,u.push(F.x,F.y,F.z),h.push(rt/y),h.push(1-G/M),U+=1}}for(let G=0;G<M;G++)for(let q=0;q<y;q++){let rt=f+q+L*G,ct=f+q+L*(G+1),$=f+(q+1)+L*(G+1),ot=f+(q+1)+L*G;c.push(rt,ct,ot),c.push(ct,$,ot),Z+=6}a.addGroup(d,Z,R),d+=Z,f+=U}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new e(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var lc=class e extends Kn{constructor(t=1,n=1,i=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:n,widthSegments:i,heightSegments:r};let s=t/2,o=n/2,a=Math.floor(i),c=Math.floor(r),l=a+1,u=c+1,h=t/a,f=n/c,d=[],p=[],_=[],g=[];for(let m=0;m<u;m++){let x=m*f-o;for(let S=0;S<l;S++){let v=S*h-s;p.push(v,-x,0),_.push(0,0,1),g.push(S/a),g.push(1-m/c)}}for(let m=0;m<c;m++)for(let x=0;x<a;x++){let S=x+l*m,v=x+l*(m+1),w=x+1+l*(m+1),b=x+1+l*m;d.push(S,v,b),d.push(v,w,b)}this.setIndex(d),this.setAttribute("position",new rn(p,3)),this.setAttribute("normal",new rn(_,3)),this.setAttribute("uv",new rn(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new e(t.width,t.height,t.widthSegments,t.heightSegments)}};var uc=class e extends Kn{constructor(t=1,n=32,i=16,r=0,s=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:n,heightSegments:i,phiStart:r,phiLength:s,thetaStart:o,thetaLength:a},n=Math.max(3,Math.floor(n)),i=Math.max(2,Math.floor(i));let c=Math.min(o+a,Math.PI),l=0,u=[],h=new V,f=new V,d=[],p=[],_=[],g=[];for(let m=0;m<=i;m++){let x=[],S=m/i,v=o+S*a,w=t*Math.cos(v),b=Math.sqrt(t*t-w*w),y=0;m===0&&o===0?y=.5/n:m===i&&c===Math.PI&&(y=-.5/n);for(let M=0;M<=n;M++){let R=M/n,C=r+R*s;h.x=-b*Math.cos(C),h.y=w,h.z=b*Math.sin(C),p.push(h.x,h.y,h.z),f.copy(h).normalize(),_.push(f.x,f.y,f.z),g.push(R+y,1-S),x.push(l++)}u.push(x)}for(let m=0;m<i;m++)for(let x=0;x<n;x++){let S=u[m][x+1],v=u[m][x],w=u[m+1][x],b=u[m+1][x+1];(m!==0||o>0)&&d.push(S,v,b),(m!==i-1||c<Math.PI)&&d.push(v,w,b)}this.setIndex(d),this.setAttribute("position",new rn(p,3)),this.setAttribute("normal",new rn(_,3)),this.setAttribute("uv",new rn(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new e(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};function Ds(e){let t={};for(let n in e){t[n]={};for(let i in e[n]){let r=e[n][i];if(xx(r))r.isRenderTargetTexture?(Dt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[n][i]=null):t[n][i]=r.clone();else if(Array.isArray(r))if(xx(r[0])){let s=[];for(let o=0,a=r.length;o<a;o++)s[o]=r[o].clone();t[n][i]=s}else t[n][i]=r.slice();else t[n][i]=r}}return t}function mn(e){let t={};for(let n=0;n<e.length;n++){let i=Ds(e[n]);for(let r in i)t[r]=i[r]}return t}function xx(e){return e&&(e.isColor||e.isMatrix3||e.isMatrix4||e.isVector2||e.isVector3||e.isVector4||e.isTexture||e.isQuaternion)}function P2(e){let t=[];for(let n=0;n<e.length;n++)t.push(e[n].clone());return t}function zp(e){let t=e.getRenderTarget();return t===null?e.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ne.workingColorSpace}var pv={clone:Ds,merge:mn},I2=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,L2=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ni=class extends gr{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=I2,this.fragmentShader=L2,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Ds(t.uniforms),this.uniformsGroups=P2(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let n=super.toJSON(t);n.glslVersion=this.glslVersion,n.uniforms={};for(let r in this.uniforms){let o=this.uniforms[r].value;o&&o.isTexture?n.uniforms[r]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?n.uniforms[r]={type:"c",value:o.getHex()}:o&&o.isVector2?n.uniforms[r]={type:"v2",value:o.toArray()}:o&&o.isVector3?n.uniforms[r]={type:"v3",value:o.toArray()}:o&&o.isVector4?n.uniforms[r]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?n.uniforms[r]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?n.uniforms[r]={type:"m4",value:o.toArray()}:n.uniforms[r]={value:o}}Object.keys(this.defines).length>0&&(n.defines=this.defines),n.vertexShader=this.vertexShader,n.fragmentShader=this.fragmentShader,n.lights=this.lights,n.clipping=this.clipping;let i={};for(let r in this.extensions)this.extensions[r]===!0&&(i[r]=!0);return Object.keys(i).length>0&&(n.extensions=i),n}fromJSON(t,n){if(super.fromJSON(t,n),t.uniforms!==void 0)for(let i in t.uniforms){let r=t.uniforms[i];switch(this.uniforms[i]={},r.type){case"t":this.uniforms[i].value=n[r.value]||null;break;case"c":this.uniforms[i].value=new jt().setHex(r.value);break;case"v2":this.uniforms[i].value=new Ft().fromArray(r.value);break;case"v3":this.uniforms[i].value=new V().fromArray(r.value);break;case"v4":this.uniforms[i].value=new we().fromArray(r.value);break;case"m3":this.uniforms[i].value=new kt().fromArray(r.value);break;case"m4":this.uniforms[i].value=new de().fromArray(r.value);break;default:this.uniforms[i].value=r.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Su=class extends Ni{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var fc=class extends gr{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new jt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new jt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Af,this.normalScale=new Ft(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new mr,this.combine=ku,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},wu=class extends gr{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=jx,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Tu=class extends gr{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function So(e,t){return!e||e.constructor===t?e:typeof t.BYTES_PER_ELEMENT=="number"?new t(e):Array.prototype.slice.call(e)}function eu(e){return e!==void 0&&e.inTangents!==void 0&&e.outTangents!==void 0}var Jr=class{constructor(t,n,i,r){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=r!==void 0?r:new n.constructor(i),this.sampleValues=n,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let n=this.parameterPositions,i=this._cachedIndex,r=n[i],s=n[i-1];t:{e:{let o;n:{i:if(!(t<r)){for(let a=i+2;;){if(r===void 0){if(t<s)break i;return i=n.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(s=r,r=n[++i],t<r)break e}o=n.length;break n}if(!(t>=s)){let a=n[1];t<a&&(i=2,s=a);for(let c=i-2;;){if(s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===c)break;if(r=s,s=n[--i-1],t>=s)break e}o=i,i=0;break n}break t}for(;i<o;){let a=i+o>>>1;t<n[a]?o=a:i=a+1}if(r=n[i],s=n[i-1],s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return i=n.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,s,r)}return this.interpolate_(i,s,t,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let n=this.resultBuffer,i=this.sampleValues,r=this.valueSize,s=t*r;for(let o=0;o!==r;++o)n[o]=i[s+o];return n}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Au=class extends Jr{constructor(t,n,i,r){super(t,n,i,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:ip,endingEnd:ip}}intervalChanged_(t,n,i){let r=this.parameterPositions,s=t-2,o=t+1,a=r[s],c=r[o];if(a===void 0)switch(this.getSettings_().endingStart){case rp:s=t,a=2*n-i;break;case sp:s=r.length-2,a=n+r[s]-r[s+1];break;default:s=t,a=i}if(c===void 0)switch(this.getSettings_().endingEnd){case rp:o=t,c=2*i-n;break;case sp:o=1,c=i+r[1]-r[0];break;default:o=t-1,c=n}let l=(i-n)*.5,u=this.valueSize;this._weightPrev=l/(n-a),this._weightNext=l/(c-i),this._offsetPrev=s*u,this._offsetNext=o*u}interpolate_(t,n,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,d=this._weightNext,p=(i-n)/(r-n),_=p*p,g=_*p,m=-f*g+2*f*_-f*p,x=(1+f)*g+(-1.5-2*f)*_+(-.5+f)*p+1,S=(-1-d)*g+(1.5+d)*_+.5*p,v=d*g-d*_;for(let w=0;w!==a;++w)s[w]=m*o[u+w]+x*o[l+w]+S*o[c+w]+v*o[h+w];return s}},Eu=class extends Jr{constructor(t,n,i,r){super(t,n,i,r)}interpolate_(t,n,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,u=(i-n)/(r-n),h=1-u;for(let f=0;f!==a;++f)s[f]=o[l+f]*h+o[c+f]*u;return s}},Cu=class extends Jr{constructor(t,n,i,r){super(t,n,i,r)}interpolate_(t){return this.copySampleValue_(t-1)}},Ru=class extends Jr{interpolate_(t,n,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let p=(i-n)/(r-n),_=1-p;for(let g=0;g!==a;++g)s[g]=o[l+g]*_+o[c+g]*p;return s}let f=a*2,d=t-1;for(let p=0;p!==a;++p){let _=o[l+p],g=o[c+p],m=d*f+p*2,x=h[m],S=h[m+1],v=t*f+p*2,w=u[v],b=u[v+1],y=D2(i,n,x,w,r);s[p]=mv(y,_,S,b,g)}return s}};function mv(e,t,n,i,r){let s=1-e;return s*s*s*t+3*s*s*e*n+3*s*e*e*i+e*e*e*r}function N2(e,t,n,i,r){let s=1-e;return 3*s*s*(n-t)+6*s*e*(i-n)+3*e*e*(r-i)}function D2(e,t,n,i,r){let s=(e-t)/(r-t);for(let o=0;o<8;o++){let a=mv(s,t,n,i,r)-e;if(Math.abs(a)<1e-10)break;let c=N2(s,t,n,i,r);if(Math.abs(c)<1e-10)break;s=Math.max(0,Math.min(1,s-a/c))}return s}var kn=class{constructor(t,n,i,r){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(n===void 0||n.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=So(n,this.TimeBufferType),this.values=So(i,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(t){let n=t.constructor,i;if(n.toJSON!==this.toJSON)i=n.toJSON(t);else{i={name:t.name,times:So(t.times,Array),values:So(t.values,Array)};let r=t.getInterpolation();r!==t.DefaultInterpolation&&(i.interpolation=r),eu(t.settings)&&(i.settings={inTangents:So(t.settings.inTangents,Array),outTangents:So(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Cu(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Eu(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Au(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let n=new Ru(this.times,this.values,this.getValueSize(),t);return this.settings&&(n.inTangents=this.settings.inTangents,n.outTangents=this.settings.outTangents),n}setInterpolation(t){let n;switch(t){case Ka:n=this.InterpolantFactoryMethodDiscrete;break;case mu:n=this.InterpolantFactoryMethodLinear;break;case ru:n=this.InterpolantFactoryMethodSmooth;break;case np:n=this.InterpolantFactoryMethodBezier;break}if(n===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Dt("KeyframeTrack:",i),this}return this.createInterpolant=n,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ka;case this.InterpolantFactoryMethodLinear:return mu;case this.InterpolantFactoryMethodSmooth:return ru;case this.InterpolantFactoryMethodBezier:return np}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let n=this.times;for(let i=0,r=n.length;i!==r;++i)n[i]+=t;eu(this.settings)&&(vx(this.settings.inTangents,t),vx(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let n=this.times;for(let i=0,r=n.length;i!==r;++i)n[i]*=t;eu(this.settings)&&(bx(this.settings.inTangents,t),bx(this.settings.outTangents,t))}return this}trim(t,n){let i=this.times,r=i.length,s=0,o=r-1;for(;s!==r&&i[s]<t;)++s;for(;o!==-1&&i[o]>n;)--o;if(++o,s!==0||o!==r){s>=o&&(o=Math.max(o,1),s=o-1);let a=this.getValueSize();this.times=i.slice(s,o),this.values=this.values.slice(s*a,o*a)}return this}validate(){let t=!0,n=this.getValueSize();n-Math.floor(n)!==0&&(Ot("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,r=this.values,s=i.length;s===0&&(Ot("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==s;a++){let c=i[a];if(typeof c=="number"&&isNaN(c)){Ot("KeyframeTrack: Time is not a valid number.",this,a,c),t=!1;break}if(o!==null&&o>c){Ot("KeyframeTrack: Out of order keys.",this,a,c,o),t=!1;break}o=c}if(r!==void 0&&JE(r))for(let a=0,c=r.length;a!==c;++a){let l=r[a];if(isNaN(l)){Ot("KeyframeTrack: Value is not a valid number.",this,a,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),n=this.values.slice(),i=this.getValueSize(),r=this.getInterpolation()===ru,s=t.length-1,o=1;for(let a=1;a<s;++a){let c=!1,l=t[a],u=t[a+1];if(l!==u&&(a!==1||l!==t[0]))if(r)c=!0;else{let h=a*i,f=h-i,d=h+i;for(let p=0;p!==i;++p){let _=n[h+p];if(_!==n[f+p]||_!==n[d+p]){c=!0;break}}}if(c){if(a!==o){t[o]=t[a];let h=a*i,f=o*i;for(let d=0;d!==i;++d)n[f+d]=n[h+d]}++o}}if(s>0){t[o]=t[s];for(let a=s*i,c=o*i,l=0;l!==i;++l)n[c+l]=n[a+l];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=n.slice(0,o*i)):(this.times=t,this.values=n),this}clone(){let t=this.times.slice(),n=this.values.slice(),i=this.constructor,r=new i(this.name,t,n);return r.createInterpolant=this.createInterpolant,eu(this.settings)&&(r.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),r}};function vx(e,t){for(let n=0,i=e.length;n!==i;n+=2)e[n]+=t}function bx(e,t){for(let n=0,i=e.length;n!==i;n+=2)e[n]*=t}kn.prototype.ValueTypeName="";kn.prototype.TimeBufferType=Float32Array;kn.prototype.ValueBufferType=Float32Array;kn.prototype.DefaultInterpolation=mu;var Kr=class extends kn{constructor(t,n,i){super(t,n,i)}};Kr.prototype.ValueTypeName="bool";Kr.prototype.ValueBufferType=Array;Kr.prototype.DefaultInterpolation=Ka;Kr.prototype.InterpolantFactoryMethodLinear=void 0;Kr.prototype.InterpolantFactoryMethodSmooth=void 0;var Pu=class extends kn{constructor(t,n,i,r){super(t,n,i,r)}};Pu.prototype.ValueTypeName="color";var Iu=class extends kn{constructor(t,n,i,r){super(t,n,i,r)}};Iu.prototype.ValueTypeName="number";var Lu=class extends Jr{constructor(t,n,i,r){super(t,n,i,r)}interpolate_(t,n,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(i-n)/(r-n),l=t*a;for(let u=l+a;l!==u;l+=4)On.slerpFlat(s,0,o,l-a,o,l,c);return s}},hc=class extends kn{constructor(t,n,i,r){super(t,n,i,r)}InterpolantFactoryMethodLinear(t){return new Lu(this.times,this.values,this.getValueSize(),t)}};hc.prototype.ValueTypeName="quaternion";hc.prototype.InterpolantFactoryMethodSmooth=void 0;var jr=class extends kn{constructor(t,n,i){super(t,n,i)}};jr.prototype.ValueTypeName="string";jr.prototype.ValueBufferType=Array;jr.prototype.DefaultInterpolation=Ka;jr.prototype.InterpolantFactoryMethodLinear=void 0;jr.prototype.InterpolantFactoryMethodSmooth=void 0;var Nu=class extends kn{constructor(t,n,i,r){super(t,n,i,r)}};Nu.prototype.ValueTypeName="vector";var Du=class{constructor(t,n,i){let r=this,s=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=n,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,s===!1&&r.onStart!==void 0&&r.onStart(u,o,a),s=!0},this.itemEnd=function(u){o++,r.onProgress!==void 0&&r.onProgress(u,o,a),o===a&&(s=!1,r.onLoad!==void 0&&r.onLoad())},this.itemError=function(u){r.onError!==void 0&&r.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),c?c(u):u},this.setURLModifier=function(u){return c=u,this},this.addHandler=function(u,h){return l.push(u,h),this},this.removeHandler=function(u){let h=l.indexOf(u);return h!==-1&&l.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=l.length;h<f;h+=2){let d=l[h],p=l[h+1];if(d.global&&(d.lastIndex=0),d.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},gv=new Du,Uu=class{constructor(t){this.manager=t!==void 0?t:gv,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,n){let i=this;return new Promise(function(r,s){i.load(t,r,n,s)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Uu.DEFAULT_MATERIAL_NAME="__DEFAULT";var dc=class extends on{static registerNode(t){this.prototype._lightNode=t}constructor(t,n=1){super(),this.isLight=!0,this.type="Light",this.color=new jt(t),this.intensity=n}copy(t,n){return super.copy(t,n),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let n=super.toJSON(t);return n.object.color=this.color.getHex(),n.object.intensity=this.intensity,n}},pc=class extends dc{constructor(t,n,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(on.DEFAULT_UP),this.updateMatrix(),this.groundColor=new jt(n)}copy(t,n){return super.copy(t,n),this.groundColor.copy(t.groundColor),this}toJSON(t){let n=super.toJSON(t);return n.object.groundColor=this.groundColor.getHex(),n}},ep=new de,Mx=new V,Sx=new V,Fu=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ft(512,512),this.mapType=En,this.map=null,this.mapPass=null,this.matrix=new de,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Zr,this._frameExtents=new Ft(1,1),this._viewportCount=1,this._viewports=[new we(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let n=this.camera;Mx.setFromMatrixPosition(t.matrixWorld),n.position.copy(Mx),Sx.setFromMatrixPosition(t.target.matrixWorld),n.lookAt(Sx),n.updateMatrixWorld(),this._updateMatrix(n,this.matrix,this._frustum)}_updateMatrix(t,n,i,r){ep.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(ep,t.coordinateSystem,t.reversedDepth);let s=this._frameExtents,o=r?r.z/s.x:1,a=r?r.w/s.y:1,c=r?r.x/s.x:0,l=r?r.y/s.y:0;t.coordinateSystem===Co||t.reversedDepth?n.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,1,0,0,0,0,1):n.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,.5,.5,0,0,0,1),n.multiply(ep)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},nu=new V,iu=new On,Ii=new V,mc=class extends on{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new de,this.projectionMatrix=new de,this.projectionMatrixInverse=new de,this.coordinateSystem=Zn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,n){return super.copy(t,n),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(nu,iu,Ii),Ii.x===1&&Ii.y===1&&Ii.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(nu,iu,Ii.set(1,1,1)).invert()}updateWorldMatrix(t,n,i=!1){super.updateWorldMatrix(t,n,i),this.matrixWorld.decompose(nu,iu,Ii),Ii.x===1&&Ii.y===1&&Ii.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(nu,iu,Ii.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},$r=new V,wx=new Ft,Tx=new Ft,vn=class extends mc{constructor(t=50,n=1,i=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=r,this.focus=10,this.aspect=n,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,n){return super.copy(t,n),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let n=.5*this.getFilmHeight()/t;this.fov=Po*2*Math.atan(n),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Za*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Po*2*Math.atan(Math.tan(Za*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,n,i){$r.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),n.set($r.x,$r.y).multiplyScalar(-t/$r.z),$r.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set($r.x,$r.y).multiplyScalar(-t/$r.z)}getViewSize(t,n){return this.getViewBounds(t,wx,Tx),n.subVectors(Tx,wx)}setViewOffset(t,n,i,r,s,o){this.aspect=t/n,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=n,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,n=t*Math.tan(Za*.5*this.fov)/this.zoom,i=2*n,r=this.aspect*i,s=-.5*r,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;s+=o.offsetX*r/c,n-=o.offsetY*i/l,r*=o.width/c,i*=o.height/l}let a=this.filmOffset;a!==0&&(s+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,n,n-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let n=super.toJSON(t);return n.object.fov=this.fov,n.object.zoom=this.zoom,n.object.near=this.near,n.object.far=this.far,n.object.focus=this.focus,n.object.aspect=this.aspect,this.view!==null&&(n.object.view=Object.assign({},this.view)),n.object.filmGauge=this.filmGauge,n.object.filmOffset=this.filmOffset,n}};var gc=class extends mc{constructor(t=-1,n=1,i=1,r=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=n,this.top=i,this.bottom=r,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(t,n){return super.copy(t,n),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,n,i,r,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=n,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),n=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=i-t,o=i+t,a=r+n,c=r-n;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=l*this.view.offsetX,o=s+l*this.view.width,a-=u*this.view.offsetY,c=a-u*this.view.height}this.projectionMatrix.makeOrthographic(s,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let n=super.toJSON(t);return n.object.zoom=this.zoom,n.object.left=this.left,n.object.right=this.right,n.object.top=this.top,n.object.bottom=this.bottom,n.object.near=this.near,n.object.far=this.far,this.view!==null&&(n.object.view=Object.assign({},this.view)),n}},op=class extends Fu{constructor(){super(new gc(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},_c=class extends dc{constructor(t,n){super(t,n),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(on.DEFAULT_UP),this.updateMatrix(),this.target=new on,this.shadow=new op}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let n=super.toJSON(t);return n.object.shadow=this.shadow.toJSON(),n.object.target=this.target.uuid,n}};var wo=-90,To=1,Bo=class extends on{constructor(t,n,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new vn(wo,To,t,n);r.layers=this.layers,this.add(r);let s=new vn(wo,To,t,n);s.layers=this.layers,this.add(s);let o=new vn(wo,To,t,n);o.layers=this.layers,this.add(o);let a=new vn(wo,To,t,n);a.layers=this.layers,this.add(a);let c=new vn(wo,To,t,n);c.layers=this.layers,this.add(c);let l=new vn(wo,To,t,n);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,n=this.children.concat(),[i,r,s,o,a,c]=n;for(let l of n)this.remove(l);if(t===Zn)i.up.set(0,1,0),i.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===Co)i.up.set(0,-1,0),i.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of n)this.add(l),l.updateMatrixWorld()}update(t,n){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:r}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[s,o,a,c,l,u]=this.children,h=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(i,0,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(n,s),t.setRenderTarget(i,1,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(n,o),t.setRenderTarget(i,2,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(n,a),t.setRenderTarget(i,3,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(n,c),t.setRenderTarget(i,4,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(n,l),i.texture.mipmapsAutoUpdate=_,t.setRenderTarget(i,5,r),g&&t.autoClear===!1&&t.clearDepth(),t.render(n,u),t.setRenderTarget(h,f,d),t.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},Ou=class extends vn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Gp="\\[\\]\\.:\\/",U2=new RegExp("["+Gp+"]","g"),Vp="[^"+Gp+"]",F2="[^"+Gp.replace("\\.","")+"]",O2=/((?:WC+[\/:])*)/.source.replace("WC",Vp),B2=/(WCOD+)?/.source.replace("WCOD",F2),k2=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Vp),z2=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Vp),G2=new RegExp("^"+O2+B2+k2+z2+"$"),V2=["material","materials","bones","map"],ap=class{constructor(t,n,i){let r=i||ve.parseTrackName(n);this._targetGroup=t,this._bindings=t.subscribe_(n,r)}getValue(t,n){this.bind();let i=this._targetGroup.nCachedObjects_,r=this._bindings[i];r!==void 0&&r.getValue(t,n)}setValue(t,n){let i=this._bindings;for(let r=this._targetGroup.nCachedObjects_,s=i.length;r!==s;++r)i[r].setValue(t,n)}bind(){let t=this._bindings;for(let n=this._targetGroup.nCachedObjects_,i=t.length;n!==i;++n)t[n].bind()}unbind(){let t=this._bindings;for(let n=this._targetGroup.nCachedObjects_,i=t.length;n!==i;++n)t[n].unbind()}},ve=class e{constructor(t,n,i){this.path=n,this.parsedPath=i||e.parseTrackName(n),this.node=e.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,n,i){return t&&t.isAnimationObjectGroup?new e.Composite(t,n,i):new e(t,n,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(U2,"")}static parseTrackName(t){let n=G2.exec(t);if(n===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:n[2],objectName:n[3],objectIndex:n[4],propertyName:n[5],propertyIndex:n[6]},r=i.nodeName&&i.nodeName.lastIndexOf(".");if(r!==void 0&&r!==-1){let s=i.nodeName.substring(r+1);V2.indexOf(s)!==-1&&(i.nodeName=i.nodeName.substring(0,r),i.objectName=s)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,n){if(n===void 0||n===""||n==="."||n===-1||n===t.name||n===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(n);if(i!==void 0)return i}if(t.children){let i=function(s){for(let o=0;o<s.length;o++){let a=s[o];if(a.name===n||a.uuid===n)return a;let c=i(a.children);if(c)return c}return null},r=i(t.children);if(r)return r}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,n){t[n]=this.targetObject[this.propertyName]}_getValue_array(t,n){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)t[n++]=i[r]}_getValue_arrayElement(t,n){t[n]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,n){this.resolvedProperty.toArray(t,n)}_setValue_direct(t,n){this.targetObject[this.propertyName]=t[n]}_setValue_direct_setNeedsUpdate(t,n){this.targetObject[this.propertyName]=t[n],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,n){this.targetObject[this.propertyName]=t[n],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,n){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=t[n++]}_setValue_array_setNeedsUpdate(t,n){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=t[n++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,n){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=t[n++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,n){this.resolvedProperty[this.propertyIndex]=t[n]}_setValue_arrayElement_setNeedsUpdate(t,n){this.resolvedProperty[this.propertyIndex]=t[n],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,n){this.resolvedProperty[this.propertyIndex]=t[n],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,n){this.resolvedProperty.fromArray(t,n)}_setValue_fromArray_setNeedsUpdate(t,n){this.resolvedProperty.fromArray(t,n),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,n){this.resolvedProperty.fromArray(t,n),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,n){this.bind(),this.getValue(t,n)}_setValue_unbound(t,n){this.bind(),this.setValue(t,n)}bind(){let t=this.node,n=this.parsedPath,i=n.objectName,r=n.propertyName,s=n.propertyIndex;if(t||(t=e.findNode(this.rootNode,n.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Dt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let l=n.objectIndex;switch(i){case"materials":if(!t.material){Ot("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Ot("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Ot("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===l){l=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Ot("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Ot("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){Ot("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(l!==void 0){if(t[l]===void 0){Ot("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let o=t[r];if(o===void 0){let l=n.nodeName;Ot("PropertyBinding: Trying to update property for track: "+l+"."+r+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(s!==void 0){if(r==="morphTargetInfluences"){if(!t.geometry){Ot("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Ot("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[s]!==void 0&&(s=t.morphTargetDictionary[s])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=s}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=r;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};ve.Composite=ap;ve.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};ve.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};ve.prototype.GetterByBindingType=[ve.prototype._getValue_direct,ve.prototype._getValue_array,ve.prototype._getValue_arrayElement,ve.prototype._getValue_toArray];ve.prototype.SetterByBindingTypeAndVersioning=[[ve.prototype._setValue_direct,ve.prototype._setValue_direct_setNeedsUpdate,ve.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[ve.prototype._setValue_array,ve.prototype._setValue_array_setNeedsUpdate,ve.prototype._setValue_array_setMatrixWorldNeedsUpdate],[ve.prototype._setValue_arrayElement,ve.prototype._setValue_arrayElement_setNeedsUpdate,ve.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[ve.prototype._setValue_fromArray,ve.prototype._setValue_fromArray_setNeedsUpdate,ve.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var K5=new Float32Array(1);var Ax=new de,yc=class{constructor(t,n,i=0,r=1/0){this.ray=new Yr(t,n),this.near=i,this.far=r,this.camera=null,this.layers=new Lo,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,n){this.ray.set(t,n)}setFromCamera(t,n){n.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(n.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(n).sub(this.ray.origin).normalize(),this.camera=n):n.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,n.projectionMatrix.elements[14]).unproject(n),this.ray.direction.set(0,0,-1).transformDirection(n.matrixWorld),this.camera=n):Ot("Raycaster: Unsupported camera type: "+n.type)}setFromXRController(t){return Ax.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Ax),this}intersectObject(t,n=!0,i=[]){return cp(t,this,i,n),i.sort(Ex),i}intersectObjects(t,n=!0,i=[]){for(let r=0,s=t.length;r<s;r++)cp(t[r],this,i,n);return i.sort(Ex),i}};function Ex(e,t){return e.distance-t.distance}function cp(e,t,n,i){let r=!0;if(e.layers.test(t.layers)&&e.raycast(t,n)===!1&&(r=!1),r===!0&&i===!0){let s=e.children;for(let o=0,a=s.length;o<a;o++)cp(s[o],t,n,!0)}}var Qr=class{constructor(t=1,n=0,i=0){this.radius=t,this.phi=n,this.theta=i}set(t,n,i){return this.radius=t,this.phi=n,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=Kt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,n,i){return this.radius=Math.sqrt(t*t+n*n+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(Kt(n/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Yp=class Yp{constructor(t,n,i,r){this.elements=[1,0,0,1],t!==void 0&&this.set(t,n,i,r)}identity(){return this.set(1,0,0,1),this}fromArray(t,n=0){for(let i=0;i<4;i++)this.elements[i]=t[i+n];return this}set(t,n,i,r){let s=this.elements;return s[0]=t,s[2]=n,s[1]=i,s[3]=r,this}};Yp.prototype.isMatrix2=!0;var lp=Yp;var xc=class extends vi{constructor(t,n=null){super(),this.object=t,this.domElement=n,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Hp(e,t,n,i){let r=H2(i);switch(n){case Cp:return e*t;case Pp:return e*t/r.components*r.byteLength;case Xu:return e*t/r.components*r.byteLength;case ns:return e*t*2/r.components*r.byteLength;case qu:return e*t*2/r.components*r.byteLength;case Rp:return e*t*3/r.components*r.byteLength;case wi:return e*t*4/r.components*r.byteLength;case Yu:return e*t*4/r.components*r.byteLength;case Mc:case Sc:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*8;case wc:case Tc:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*16;case Ju:case ju:return Math.max(e,16)*Math.max(t,8)/4;case Zu:case Ku:return Math.max(e,8)*Math.max(t,8)/2;case Qu:case tf:case nf:case rf:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*8;case ef:case Ac:case sf:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*16;case of:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*16;case af:return Math.floor((e+4)/5)*Math.floor((t+3)/4)*16;case cf:return Math.floor((e+4)/5)*Math.floor((t+4)/5)*16;case lf:return Math.floor((e+5)/6)*Math.floor((t+4)/5)*16;case uf:return Math.floor((e+5)/6)*Math.floor((t+5)/6)*16;case ff:return Math.floor((e+7)/8)*Math.floor((t+4)/5)*16;case hf:return Math.floor((e+7)/8)*Math.floor((t+5)/6)*16;case df:return Math.floor((e+7)/8)*Math.floor((t+7)/8)*16;case pf:return Math.floor((e+9)/10)*Math.floor((t+4)/5)*16;case mf:return Math.floor((e+9)/10)*Math.floor((t+5)/6)*16;case gf:return Math.floor((e+9)/10)*Math.floor((t+7)/8)*16;case _f:return Math.floor((e+9)/10)*Math.floor((t+9)/10)*16;case yf:return Math.floor((e+11)/12)*Math.floor((t+9)/10)*16;case xf:return Math.floor((e+11)/12)*Math.floor((t+11)/12)*16;case vf:case bf:case Mf:return Math.ceil(e/4)*Math.ceil(t/4)*16;case Sf:case wf:return Math.ceil(e/4)*Math.ceil(t/4)*8;case Ec:case Tf:return Math.ceil(e/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${n} format.`)}function H2(e){switch(e){case En:case wp:return{byteLength:1,components:1};case Vo:case Tp:case Si:return{byteLength:2,components:1};case Wu:case $u:return{byteLength:2,components:4};case bi:case Hu:case Mi:return{byteLength:4,components:1};case Ap:case Ep:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${e}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Dt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Bv(){let e=null,t=!1,n=null,i=null;function r(s,o){i=e.requestAnimationFrame(r),n(s,o)}return{start:function(){t!==!0&&n!==null&&e!==null&&(i=e.requestAnimationFrame(r),t=!0)},stop:function(){e!==null&&e.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(s){n=s},setContext:function(s){e=s}}}function $2(e){let t=new WeakMap;function n(a,c){let l=a.array,u=a.usage,h=l.byteLength,f=e.createBuffer();e.bindBuffer(c,f),e.bufferData(c,l,u),a.onUploadCallback();let d;if(l instanceof Float32Array)d=e.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)d=e.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?d=e.HALF_FLOAT:d=e.UNSIGNED_SHORT;else if(l instanceof Int16Array)d=e.SHORT;else if(l instanceof Uint32Array)d=e.UNSIGNED_INT;else if(l instanceof Int32Array)d=e.INT;else if(l instanceof Int8Array)d=e.BYTE;else if(l instanceof Uint8Array)d=e.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)d=e.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:f,type:d,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,c,l){let u=c.array,h=c.updateRanges;if(e.bindBuffer(l,a),h.length===0)e.bufferSubData(l,0,u);else{h.sort((d,p)=>d.start-p.start);let f=0;for(let d=1;d<h.length;d++){let p=h[f],_=h[d];_.start<=p.start+p.count+1?p.count=Math.max(p.count,_.start+_.count-p.start):(++f,h[f]=_)}h.length=f+1;for(let d=0,p=h.length;d<p;d++){let _=h[d];e.bufferSubData(l,_.start*u.BYTES_PER_ELEMENT,u,_.start,_.count)}c.clearUpdateRanges()}c.onUploadCallback()}function r(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function s(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=t.get(a);c&&(e.deleteBuffer(c.buffer),t.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=t.get(a);if(l===void 0)t.set(a,n(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(l.buffer,a,c),l.version=a.version}}return{get:r,remove:s,update:o}}var X2=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,q2=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Y2=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Z2=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,J2=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,K2=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,j2=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Q2=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,t3=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,e3=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,n3=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,i3=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,r3=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,s3=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,o3=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,a3=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,c3=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,l3=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,u3=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,f3=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,h3=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,d3=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,p3=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,m3=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,g3=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,_3=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,y3=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,x3=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,v3=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,b3="gl_FragColor = linearToOutputTexel( gl_FragColor );",M3=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,S3=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,w3=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,T3=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,A3=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,E3=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,C3=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,R3=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,P3=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,I3=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,L3=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,N3=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,D3=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,U3=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,F3=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,O3=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,B3=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,k3=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,z3=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,G3=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,V3=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,H3=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,W3=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,$3=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,X3=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,q3=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Y3=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Z3=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,J3=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,K3=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,j3=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Q3=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,tC=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,eC=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,nC=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,iC=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,rC=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,sC=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,oC=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,aC=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,cC=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,lC=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,uC=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,fC=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,hC=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,dC=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,pC=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,mC=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,gC=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,_C=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,yC=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,xC=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,vC=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,bC=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,MC=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,SC=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,wC=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,TC=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,AC=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,EC=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,CC=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,RC=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,PC=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,IC=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,LC=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,NC=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,DC=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,UC=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,FC=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,OC=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,BC=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,kC=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,zC=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,GC=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,VC=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,HC=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,WC=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,$C=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,XC=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,qC=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,YC=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ZC=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,JC=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,KC=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,jC=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,QC=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,tR=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,eR=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,nR=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,iR=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,rR=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,sR=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,oR=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,aR=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,cR=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,lR=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,uR=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,fR=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,hR=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,dR=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,pR=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,mR=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,gR=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,_R=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,yR=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,xR=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,vR=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,bR=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,MR=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,SR=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,wR=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,Zt={alphahash_fragment:X2,alphahash_pars_fragment:q2,alphamap_fragment:Y2,alphamap_pars_fragment:Z2,alphatest_fragment:J2,alphatest_pars_fragment:K2,aomap_fragment:j2,aomap_pars_fragment:Q2,batching_pars_vertex:t3,batching_vertex:e3,begin_vertex:n3,beginnormal_vertex:i3,bsdfs:r3,iridescence_fragment:s3,bumpmap_pars_fragment:o3,clipping_planes_fragment:a3,clipping_planes_pars_fragment:c3,clipping_planes_pars_vertex:l3,clipping_planes_vertex:u3,color_fragment:f3,color_pars_fragment:h3,color_pars_vertex:d3,color_vertex:p3,common:m3,defaultnormal_vertex:g3,displacementmap_pars_vertex:_3,displacementmap_vertex:y3,emissivemap_fragment:x3,emissivemap_pars_fragment:v3,colorspace_fragment:b3,colorspace_pars_fragment:M3,envmap_fragment:S3,envmap_common_pars_fragment:w3,envmap_pars_fragment:T3,envmap_pars_vertex:A3,envmap_physical_pars_fragment:O3,envmap_vertex:E3,fog_vertex:C3,fog_pars_vertex:R3,fog_fragment:P3,fog_pars_fragment:I3,gradientmap_pars_fragment:L3,lightmap_pars_fragment:N3,lights_lambert_fragment:D3,lights_lambert_pars_fragment:U3,lights_pars_begin:F3,lights_toon_fragment:B3,lights_toon_pars_fragment:k3,lights_phong_fragment:z3,lights_phong_pars_fragment:G3,lights_physical_fragment:V3,lights_physical_pars_fragment:H3,lights_fragment_begin:W3,lights_fragment_maps:$3,lights_fragment_end:X3,lightprobes_pars_fragment:q3,logdepthbuf_fragment:Y3,logdepthbuf_pars_fragment:Z3,logdepthbuf_pars_vertex:J3,logdepthbuf_vertex:K3,map_fragment:j3,map_pars_fragment:Q3,map_particle_fragment:tC,map_particle_pars_fragment:eC,metalnessmap_fragment:nC,metalnessmap_pars_fragment:iC,morphinstance_vertex:rC,morphcolor_vertex:sC,morphnormal_vertex:oC,morphtarget_pars_vertex:aC,morphtarget_vertex:cC,normal_fragment_begin:lC,normal_fragment_maps:uC,normal_pars_fragment:fC,normal_pars_vertex:hC,normal_vertex:dC,normalmap_pars_fragment:pC,clearcoat_normal_fragment_begin:mC,clearcoat_normal_fragment_maps:gC,clearcoat_pars_fragment:_C,iridescence_pars_fragment:yC,opaque_fragment:xC,packing:vC,premultiplied_alpha_fragment:bC,project_vertex:MC,dithering_fragment:SC,dithering_pars_fragment:wC,roughnessmap_fragment:TC,roughnessmap_pars_fragment:AC,shadowmap_pars_fragment:EC,shadowmap_pars_vertex:CC,shadowmap_vertex:RC,shadowmask_pars_fragment:PC,skinbase_vertex:IC,skinning_pars_vertex:LC,skinning_vertex:NC,skinnormal_vertex:DC,specularmap_fragment:UC,specularmap_pars_fragment:FC,tonemapping_fragment:OC,tonemapping_pars_fragment:BC,transmission_fragment:kC,transmission_pars_fragment:zC,uv_pars_fragment:GC,uv_pars_vertex:VC,uv_vertex:HC,worldpos_vertex:WC,background_vert:$C,background_frag:XC,backgroundCube_vert:qC,backgroundCube_frag:YC,cube_vert:ZC,cube_frag:JC,depth_vert:KC,depth_frag:jC,distance_vert:QC,distance_frag:tR,equirect_vert:eR,equirect_frag:nR,linedashed_vert:iR,linedashed_frag:rR,meshbasic_vert:sR,meshbasic_frag:oR,meshlambert_vert:aR,meshlambert_frag:cR,meshmatcap_vert:lR,meshmatcap_frag:uR,meshnormal_vert:fR,meshnormal_frag:hR,meshphong_vert:dR,meshphong_frag:pR,meshphysical_vert:mR,meshphysical_frag:gR,meshtoon_vert:_R,meshtoon_frag:yR,points_vert:xR,points_frag:vR,shadow_vert:bR,shadow_frag:MR,sprite_vert:SR,sprite_frag:wR},Tt={common:{diffuse:{value:new jt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new kt},alphaMap:{value:null},alphaMapTransform:{value:new kt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new kt}},envmap:{envMap:{value:null},envMapRotation:{value:new kt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new kt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new kt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new kt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new kt},normalScale:{value:new Ft(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new kt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new kt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new kt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new kt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new jt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new jt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new kt},alphaTest:{value:0},uvTransform:{value:new kt}},sprite:{diffuse:{value:new jt(16777215)},opacity:{value:1},center:{value:new Ft(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new kt},alphaMap:{value:null},alphaMapTransform:{value:new kt},alphaTest:{value:0}}},Bi={basic:{uniforms:mn([Tt.common,Tt.specularmap,Tt.envmap,Tt.aomap,Tt.lightmap,Tt.fog]),vertexShader:Zt.meshbasic_vert,fragmentShader:Zt.meshbasic_frag},lambert:{uniforms:mn([Tt.common,Tt.specularmap,Tt.envmap,Tt.aomap,Tt.lightmap,Tt.emissivemap,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,Tt.fog,Tt.lights,{emissive:{value:new jt(0)},envMapIntensity:{value:1}}]),vertexShader:Zt.meshlambert_vert,fragmentShader:Zt.meshlambert_frag},phong:{uniforms:mn([Tt.common,Tt.specularmap,Tt.envmap,Tt.aomap,Tt.lightmap,Tt.emissivemap,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,Tt.fog,Tt.lights,{emissive:{value:new jt(0)},specular:{value:new jt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Zt.meshphong_vert,fragmentShader:Zt.meshphong_frag},standard:{uniforms:mn([Tt.common,Tt.envmap,Tt.aomap,Tt.lightmap,Tt.emissivemap,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,Tt.roughnessmap,Tt.metalnessmap,Tt.fog,Tt.lights,{emissive:{value:new jt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Zt.meshphysical_vert,fragmentShader:Zt.meshphysical_frag},toon:{uniforms:mn([Tt.common,Tt.aomap,Tt.lightmap,Tt.emissivemap,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,Tt.gradientmap,Tt.fog,Tt.lights,{emissive:{value:new jt(0)}}]),vertexShader:Zt.meshtoon_vert,fragmentShader:Zt.meshtoon_frag},matcap:{uniforms:mn([Tt.common,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,Tt.fog,{matcap:{value:null}}]),vertexShader:Zt.meshmatcap_vert,fragmentShader:Zt.meshmatcap_frag},points:{uniforms:mn([Tt.points,Tt.fog]),vertexShader:Zt.points_vert,fragmentShader:Zt.points_frag},dashed:{uniforms:mn([Tt.common,Tt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Zt.linedashed_vert,fragmentShader:Zt.linedashed_frag},depth:{uniforms:mn([Tt.common,Tt.displacementmap]),vertexShader:Zt.depth_vert,fragmentShader:Zt.depth_frag},normal:{uniforms:mn([Tt.common,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,{opacity:{value:1}}]),vertexShader:Zt.meshnormal_vert,fragmentShader:Zt.meshnormal_frag},sprite:{uniforms:mn([Tt.sprite,Tt.fog]),vertexShader:Zt.sprite_vert,fragmentShader:Zt.sprite_frag},background:{uniforms:{uvTransform:{value:new kt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Zt.background_vert,fragmentShader:Zt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new kt}},vertexShader:Zt.backgroundCube_vert,fragmentShader:Zt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Zt.cube_vert,fragmentShader:Zt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Zt.equirect_vert,fragmentShader:Zt.equirect_frag},distance:{uniforms:mn([Tt.common,Tt.displacementmap,{referencePosition:{value:new V},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Zt.distance_vert,fragmentShader:Zt.distance_frag},shadow:{uniforms:mn([Tt.lights,Tt.fog,{color:{value:new jt(0)},opacity:{value:1}}]),vertexShader:Zt.shadow_vert,fragmentShader:Zt.shadow_frag}};Bi.physical={uniforms:mn([Bi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new kt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new kt},clearcoatNormalScale:{value:new Ft(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new kt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new kt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new kt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new kt},sheen:{value:0},sheenColor:{value:new jt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new kt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new kt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new kt},transmissionSamplerSize:{value:new Ft},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new kt},attenuationDistance:{value:0},attenuationColor:{value:new jt(0)},specularColor:{value:new jt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new kt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new kt},anisotropyVector:{value:new Ft},anisotropyMap:{value:null},anisotropyMapTransform:{value:new kt}}]),vertexShader:Zt.meshphysical_vert,fragmentShader:Zt.meshphysical_frag};var Ef={r:0,b:0,g:0},TR=new de,kv=new kt;kv.set(-1,0,0,0,1,0,0,0,1);function AR(e,t,n,i,r,s){let o=new jt(0),a=r===!0?0:1,c,l,u=null,h=0,f=null;function d(x){let S=x.isScene===!0?x.background:null;if(S&&S.isTexture){let v=x.backgroundBlurriness>0;S=t.get(S,v)}return S}function p(x){let S=!1,v=d(x);v===null?g(o,a):v&&v.isColor&&(g(v,1),S=!0);let w=e.xr.getEnvironmentBlendMode();w==="additive"?n.buffers.color.setClear(0,0,0,1,s):w==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,s),(e.autoClear||S)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),e.clear(e.autoClearColor,e.autoClearDepth,e.autoClearStencil))}function _(x,S){let v=d(S);v&&v.isCubeTexture?(l===void 0&&(l=new jn(new Oo(1,1,1),new Ni({name:"BackgroundCubeMaterial",uniforms:Ds(Bi.backgroundCube.uniforms),vertexShader:Bi.backgroundCube.vertexShader,fragmentShader:Bi.backgroundCube.fragmentShader,side:an,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(w,b,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(l)),l.material.uniforms.envMap.value=v,l.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(TR.makeRotationFromEuler(S.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(kv),l.material.toneMapped=ne.getTransfer(v.colorSpace)!==le,(u!==v||h!==v.version||f!==e.toneMapping)&&(l.material.needsUpdate=!0,u=v,h=v.version,f=e.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null)):v&&v.isTexture&&(c===void 0&&(c=new jn(new lc(2,2),new Ni({name:"BackgroundMaterial",uniforms:Ds(Bi.background.uniforms),vertexShader:Bi.background.vertexShader,fragmentShader:Bi.background.fragmentShader,side:Di,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(c)),c.material.uniforms.t2D.value=v,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.toneMapped=ne.getTransfer(v.colorSpace)!==le,v.matrixAutoUpdate===!0&&v.updateMatrix(),c.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||h!==v.version||f!==e.toneMapping)&&(c.material.needsUpdate=!0,u=v,h=v.version,f=e.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null))}function g(x,S){x.getRGB(Ef,zp(e)),n.buffers.color.setClear(Ef.r,Ef.g,Ef.b,S,s)}function m(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,S=1){o.set(x),a=S,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,g(o,a)},render:p,addToRenderList:_,dispose:m}}function ER(e,t){let n=e.getParameter(e.MAX_VERTEX_ATTRIBS),i={},r=f(null),s=r,o=!1;function a(E,N,k,P,L){let B=!1,U=h(E,P,k,N);s!==U&&(s=U,l(s.object)),B=d(E,P,k,L),B&&p(E,P,k,L),L!==null&&t.update(L,e.ELEMENT_ARRAY_BUFFER),(B||o)&&(o=!1,v(E,N,k,P),L!==null&&e.bindBuffer(e.ELEMENT_ARRAY_BUFFER,t.get(L).buffer))}function c(){return e.createVertexArray()}function l(E){return e.bindVertexArray(E)}function u(E){return e.deleteVertexArray(E)}function h(E,N,k,P){let L=P.wireframe===!0,B=i[N.id];B===void 0&&(B={},i[N.id]=B);let U=E.isInstancedMesh===!0?E.id:0,Z=B[U];Z===void 0&&(Z={},B[U]=Z);let F=Z[k.id];F===void 0&&(F={},Z[k.id]=F);let G=F[L];return G===void 0&&(G=f(c()),F[L]=G),G}function f(E){let N=[],k=[],P=[];for(let L=0;L<n;L++)N[L]=0,k[L]=0,P[L]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:N,enabledAttributes:k,attributeDivisors:P,object:E,attributes:{},index:null}}function d(E,N,k,P){let L=s.attributes,B=N.attributes,U=0,Z=k.getAttributes();for(let F in Z)if(Z[F].location>=0){let q=L[F],rt=B[F];if(rt===void 0&&(F==="instanceMatrix"&&E.instanceMatrix&&(rt=E.instanceMatrix),F==="instanceColor"&&E.instanceColor&&(rt=E.instanceColor)),q===void 0||q.attribute!==rt||rt&&q.data!==rt.data)return!0;U++}return s.attributesNum!==U||s.index!==P}function p(E,N,k,P){let L={},B=N.attributes,U=0,Z=k.getAttributes();for(let F in Z)if(Z[F].location>=0){let q=B[F];q===void 0&&(F==="instanceMatrix"&&E.instanceMatrix&&(q=E.instanceMatrix),F==="instanceColor"&&E.instanceColor&&(q=E.instanceColor));let rt={};rt.attribute=q,q&&q.data&&(rt.data=q.data),L[F]=rt,U++}s.attributes=L,s.attributesNum=U,s.index=P}function _(){let E=s.newAttributes;for(let N=0,k=E.length;N<k;N++)E[N]=0}function g(E){m(E,0)}function m(E,N){let k=s.newAttributes,P=s.enabledAttributes,L=s.attributeDivisors;k[E]=1,P[E]===0&&(e.enableVertexAttribArray(E),P[E]=1),L[E]!==N&&(e.vertexAttribDivisor(E,N),L[E]=N)}function x(){let E=s.newAttributes,N=s.enabledAttributes;for(let k=0,P=N.length;k<P;k++)N[k]!==E[k]&&(e.disableVertexAttribArray(k),N[k]=0)}function S(E,N,k,P,L,B,U){U===!0?e.vertexAttribIPointer(E,N,k,L,B):e.vertexAttribPointer(E,N,k,P,L,B)}function v(E,N,k,P){_();let L=P.attributes,B=k.getAttributes(),U=N.defaultAttributeValues;for(let Z in B){let F=B[Z];if(F.location>=0){let G=L[Z];if(G===void 0&&(Z==="instanceMatrix"&&E.instanceMatrix&&(G=E.instanceMatrix),Z==="instanceColor"&&E.instanceColor&&(G=E.instanceColor)),G!==void 0){let q=G.normalized,rt=G.itemSize,ct=t.get(G);if(ct===void 0)continue;let $=ct.buffer,ot=ct.type,ut=ct.bytesPerElement,st=ot===e.INT||ot===e.UNSIGNED_INT||G.gpuType===Hu;if(G.isInterleavedBufferAttribute){let at=G.data,J=at.isInterleavedBuffer===!0?at.stride:at.itemSize,yt=G.offset;if(at.isInstancedInterleavedBuffer||at.isInstancedBufferAttribute){for(let lt=0;lt<F.locationSize;lt++)m(F.location+lt,at.meshPerAttribute);E.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=at.meshPerAttribute*at.count)}else for(let lt=0;lt<F.locationSize;lt++)g(F.location+lt);e.bindBuffer(e.ARRAY_BUFFER,$);for(let lt=0;lt<F.locationSize;lt++)S(F.location+lt,rt/F.locationSize,ot,q,J*ut,(yt+rt/F.locationSize*lt)*ut,st)}else{if(G.isInstancedBufferAttribute){for(let at=0;at<F.locationSize;at++)m(F.location+at,G.meshPerAttribute);E.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=G.meshPerAttribute*G.count)}else for(let at=0;at<F.locationSize;at++)g(F.location+at);e.bindBuffer(e.ARRAY_BUFFER,$);for(let at=0;at<F.locationSize;at++)S(F.location+at,rt/F.locationSize,ot,q,rt*ut,rt/F.locationSize*at*ut,st)}}else if(U!==void 0){let q=U[Z];if(q!==void 0)switch(q.length){case 2:e.vertexAttrib2fv(F.location,q);break;case 3:e.vertexAttrib3fv(F.location,q);break;case 4:e.vertexAttrib4fv(F.location,q);break;default:e.vertexAttrib1fv(F.location,q)}}}}x()}function w(){R();for(let E in i){let N=i[E];for(let k in N){let P=N[k];for(let L in P){let B=P[L];for(let U in B)u(B[U].object),delete B[U];delete P[L]}}delete i[E]}}function b(E){if(i[E.id]===void 0)return;let N=i[E.id];for(let k in N){let P=N[k];for(let L in P){let B=P[L];for(let U in B)u(B[U].object),delete B[U];delete P[L]}}delete i[E.id]}function y(E){for(let N in i){let k=i[N];for(let P in k){let L=k[P];if(L[E.id]===void 0)continue;let B=L[E.id];for(let U in B)u(B[U].object),delete B[U];delete L[E.id]}}}function M(E){for(let N in i){let k=i[N],P=E.isInstancedMesh===!0?E.id:0,L=k[P];if(L!==void 0){for(let B in L){let U=L[B];for(let Z in U)u(U[Z].object),delete U[Z];delete L[B]}delete k[P],Object.keys(k).length===0&&delete i[N]}}}function R(){C(),o=!0,s!==r&&(s=r,l(s.object))}function C(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:a,reset:R,resetDefaultState:C,dispose:w,releaseStatesOfGeometry:b,releaseStatesOfObject:M,releaseStatesOfProgram:y,initAttributes:_,enableAttribute:g,disableUnusedAttributes:x}}function CR(e,t,n){let i;function r(c){i=c}function s(c,l){e.drawArrays(i,c,l),n.update(l,i,1)}function o(c,l,u){u!==0&&(e.drawArraysInstanced(i,c,l,u),n.update(l,i,u))}function a(c,l,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,l,0,u);let f=0;for(let d=0;d<u;d++)f+=l[d];n.update(f,i,1)}this.setMode=r,this.render=s,this.renderInstances=o,this.renderMultiDraw=a}function RR(e,t,n,i){let r;function s(){if(r!==void 0)return r;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");r=e.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function o(y){return!(y!==wi&&i.convert(y)!==e.getParameter(e.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let M=y===Si&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==En&&y!==Mi&&!M&&i.convert(y)!==e.getParameter(e.IMPLEMENTATION_COLOR_READ_TYPE))}function c(y){if(y==="highp"){if(e.getShaderPrecisionFormat(e.VERTEX_SHADER,e.HIGH_FLOAT).precision>0&&e.getShaderPrecisionFormat(e.FRAGMENT_SHADER,e.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&e.getShaderPrecisionFormat(e.VERTEX_SHADER,e.MEDIUM_FLOAT).precision>0&&e.getShaderPrecisionFormat(e.FRAGMENT_SHADER,e.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=n.precision!==void 0?n.precision:"highp",u=c(l);u!==l&&(Dt("WebGLRenderer:",l,"not supported, using",u,"instead."),l=u);let h=n.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),f=n.logarithmicDepthBuffer===!0&&h===!1;n.reversedDepthBuffer===!0&&h===!1&&Dt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),n.logarithmicDepthBuffer===!0&&h===!0&&Dt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=e.getParameter(e.MAX_TEXTURE_IMAGE_UNITS),p=e.getParameter(e.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=e.getParameter(e.MAX_TEXTURE_SIZE),g=e.getParameter(e.MAX_CUBE_MAP_TEXTURE_SIZE),m=e.getParameter(e.MAX_VERTEX_ATTRIBS),x=e.getParameter(e.MAX_VERTEX_UNIFORM_VECTORS),S=e.getParameter(e.MAX_VARYING_VECTORS),v=e.getParameter(e.MAX_FRAGMENT_UNIFORM_VECTORS),w=e.getParameter(e.MAX_SAMPLES),b=e.getParameter(e.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:f,reversedDepthBuffer:h,maxTextures:d,maxVertexTextures:p,maxTextureSize:_,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:x,maxVaryings:S,maxFragmentUniforms:v,maxSamples:w,samples:b}}function PR(e){let t=this,n=null,i=0,r=!1,s=!1,o=new xn,a=new kt,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let d=h.length!==0||f||i!==0||r;return r=f,i=h.length,d},this.beginShadows=function(){s=!0,u(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(h,f){n=u(h,f,0)},this.setState=function(h,f,d){let p=h.clippingPlanes,_=h.clipIntersection,g=h.clipShadows,m=e.get(h);if(!r||p===null||p.length===0||s&&!g)s?u(null):l();else{let x=s?0:i,S=x*4,v=m.clippingState||null;c.value=v,v=u(p,f,S,d);for(let w=0;w!==S;++w)v[w]=n[w];m.clippingState=v,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=x}};function l(){c.value!==n&&(c.value=n,c.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,f,d,p){let _=h!==null?h.length:0,g=null;if(_!==0){if(g=c.value,p!==!0||g===null){let m=d+_*4,x=f.matrixWorldInverse;a.getNormalMatrix(x),(g===null||g.length<m)&&(g=new Float32Array(m));for(let S=0,v=d;S!==_;++S,v+=4)o.copy(h[S]).applyMatrix4(x,a),o.normal.toArray(g,v),g[v+3]=o.constant}c.value=g,c.needsUpdate=!0}return t.numPlanes=_,t.numIntersection=0,g}}var Pc=class extends Bn{constructor(t=1,n={}){super(t,t,n),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},r=[i,i,i,i,i,i];this.texture=new oc(r),this._setTextureOptions(n),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,n){this.texture.type=n.type,this.texture.colorSpace=n.colorSpace,this.texture.generateMipmaps=n.generateMipmaps,this.texture.minFilter=n.minFilter,this.texture.magFilter=n.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},r=new Oo(5,5,5),s=new Ni({name:"CubemapFromEquirect",uniforms:Ds(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:an,blending:Ps});s.uniforms.tEquirect.value=n;let o=new jn(r,s),a=n.minFilter;return n.minFilter===yr&&(n.minFilter=sn),new Bo(1,10,this).update(t,o),n.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,n=!0,i=!0,r=!0){let s=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(n,i,r);t.setRenderTarget(s)}},_v=256,IR=3,LR=20,zv=256,Gv=16,NR=3,DR=new V,UR=new jt,Rf=class e{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Bo(1,10,null),this._boxMesh=new jn(new Oo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,n=0,i=.1,r=100,s={}){let{size:o=256,position:a=DR}=s,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),u=this._getSourceTarget(!0);n>0&&(u.texture.mipmapsAutoUpdate=!1);let h=c.autoClear,f=c.autoClearColor,d=c.autoClearDepth,p=c.autoClearStencil,_=t.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,_===null&&(t.background=c.getClearColor(UR));let g=new Bo(i,r,u);return g.position.copy(a),g.update(c,t),c.autoClear=h,c.autoClearColor=f,c.autoClearDepth=d,c.autoClearStencil=p,t.background=_,n>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(l,n)),this._applyPMREM(l),l}fromEquirectangular(t,n=null){return this._fromTexture(t,n)}fromCubemap(t,n=null){return this._fromTexture(t,n)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=vv(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=xv(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,n){return n>0?1-Math.sqrt(1-t/n):0}_setSize(t){this._cubeSize=Math.max(_v,Op(t))}_fromTexture(t,n){t.mapping===Ls||t.mapping===Go?this._setSize(t.image.length===0?_v:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=n||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,n=yv(t,!1,!1),i=Math.log2(t)-IR;for(let r=0;r<=i;r++)n.texture.mipmaps.push({width:t>>r,height:t>>r});return n.texture.name="PMREM",n.texture.isPMREMTexture=!0,n}_getSourceTarget(t=!1){let n=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==n||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=yv(n,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,n,i){let r=this._boxMesh,s=this._cubeCamera;r.material=i,s.renderTarget=t,s.activeMipmapLevel=n;let o=t.width>>n;t.viewport.set(0,0,o,o),s.update(this._renderer,r),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let n;t.mapping===Ls||t.mapping===Go?(this._cubemapMaterial===null&&(this._cubemapMaterial=vv()),n=this._cubemapMaterial,n.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=xv()),n=this._equirectMaterial),n.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,n)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=FR(),this._integrationMaterial=OR());let n=this._cubeSize,i=t.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(n/Gv);for(let o=0;o<=i;o++){let a=e.lodToRoughness(o,i);if(o>i-NR)s.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let c=a>0?Math.log2(n)+.5*Math.log2(6/(zv*Math.pow(a,4)))+.5:0;r.roughness.value=a,r.lodBias.value=c,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,n){this._blurMaterial===null&&(this._blurMaterial=BR());let i=this._blurMaterial,r=i.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(n,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(t,0,i),r.envMap.value=t.texture,this._renderCube(s,0,i)}};function yv(e,t,n){return new Pc(e,{minFilter:yr,generateMipmaps:t,type:Si,colorSpace:ja,depthBuffer:n})}function Ic(e,t,n){return new Ni({name:e,uniforms:t,vertexShader:Zt.cube_vert,fragmentShader:n,side:an,blending:Ps,depthTest:!1,depthWrite:!1})}function FR(){return Ic("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${zv}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function OR(){return Ic("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Gv}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function BR(){return Ic("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${LR}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function xv(){return Ic("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function vv(){return Ic("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function kR(e){let t=new WeakMap,n=new WeakMap,i=null;function r(f,d=!1){return f==null?null:d?o(f):s(f)}function s(f){if(f&&f.isTexture){let d=f.mapping;if(d===zu||d===Gu)if(t.has(f)){let p=t.get(f).texture;return a(p,f.mapping)}else{let p=f.image;if(p&&p.height>0){let _=new Pc(p.height);return _.fromEquirectangularTexture(e,f),t.set(f,_),f.addEventListener("dispose",l),a(_.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,p=d===zu||d===Gu,_=d===Ls||d===Go;if(p||_){let g=n.get(f),m=g!==void 0?g.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==m)return i===null&&(i=new Rf(e)),g=p?i.fromEquirectangular(f,g):i.fromCubemap(f,g),g.texture.pmremVersion=f.pmremVersion,n.set(f,g),g.texture;if(g!==void 0)return g.texture;{let x=f.image;return p&&x&&x.height>0||_&&x&&c(x)?(i===null&&(i=new Rf(e)),g=p?i.fromEquirectangular(f):i.fromCubemap(f),g.texture.pmremVersion=f.pmremVersion,n.set(f,g),f.addEventListener("dispose",u),g.texture):null}}}return f}function a(f,d){return d===zu?f.mapping=Ls:d===Gu&&(f.mapping=Go),f}function c(f){let d=0,p=6;for(let _=0;_<p;_++)f[_]!==void 0&&d++;return d===p}function l(f){let d=f.target;d.removeEventListener("dispose",l);let p=t.get(d);p!==void 0&&(t.delete(d),p.dispose())}function u(f){let d=f.target;d.removeEventListener("dispose",u);let p=n.get(d);p!==void 0&&(n.delete(d),p.dispose())}function h(){t=new WeakMap,n=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:r,dispose:h}}function zR(e){let t={};function n(i){if(t[i]!==void 0)return t[i];let r=e.getExtension(i);return t[i]=r,r}return{has:function(i){return n(i)!==null},init:function(){n("EXT_color_buffer_float"),n("WEBGL_clip_cull_distance"),n("OES_texture_float_linear"),n("EXT_color_buffer_half_float"),n("WEBGL_multisampled_render_to_texture"),n("WEBGL_render_shared_exponent")},get:function(i){let r=n(i);return r===null&&Ya("WebGLRenderer: "+i+" extension not supported."),r}}}function GR(e,t,n,i){let r={},s=new WeakMap,o=new FinalizationRegistry(p=>delete r[p]);function a(p){c(p.target)}function c(p){p.index!==null&&t.remove(p.index);for(let g in p.attributes)t.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete r[p.id],o.unregister(p);let _=s.get(p);_&&(t.remove(_),s.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,n.memory.geometries--}function l(p,_){return r[_.id]!==void 0||(_.addEventListener("dispose",a),r[_.id]=new WeakRef(_),o.register(_,_.id,_),n.memory.geometries++),_}function u(p){let _=p.attributes;for(let g in _)t.update(_[g],e.ARRAY_BUFFER)}function h(p){let _=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let x=_!==null?_.array.length:g.array.length/3-1,S=g.count>=65535?rc:ic,v=new S(Math.ceil(x/3)*6,1),w=v.array;if(_!==null){let y=_.array;m=_.version;for(let M=0,R=0;M<x;M+=3){let C=y[M+0],E=y[M+1],N=y[M+2];w[R++]=C,w[R++]=E,w[R++]=E,w[R++]=N,w[R++]=N,w[R++]=C}}else{m=g.version;for(let y=0,M=0;y<x;y+=3){let R=y+0,C=y+1,E=y+2;w[M++]=R,w[M++]=C,w[M++]=C,w[M++]=E,w[M++]=E,w[M++]=R}}v.version=m;let b=s.get(p);b&&t.remove(b),s.set(p,v)}function f(p){let _=s.get(p);if(_){let g=p.index;g!==null&&_.version<g.version&&h(p)}else h(p);return s.get(p)}function d(){for(let p in r){let _=r[p].deref();_!==void 0&&c(_)}}return{get:l,update:u,getWireframeAttribute:f,dispose:d}}function VR(e,t,n){let i;function r(h){i=h}let s,o;function a(h){s=h.type,o=h.bytesPerElement}function c(h,f){e.drawElements(i,f,s,h*o),n.update(f,i,1)}function l(h,f,d){d!==0&&(e.drawElementsInstanced(i,f,s,h*o,d),n.update(f,i,d))}function u(h,f,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,s,h,0,d);let _=0;for(let g=0;g<d;g++)_+=f[g];n.update(_,i,1)}this.setMode=r,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=u}function HR(e){let t={geometries:0,textures:0},n={frame:0,calls:0,triangles:0,points:0,lines:0};function i(s,o,a){switch(n.calls++,o){case e.TRIANGLES:n.triangles+=a*(s/3);break;case e.LINES:n.lines+=a*(s/2);break;case e.LINE_STRIP:n.lines+=a*(s-1);break;case e.LINE_LOOP:n.lines+=a*s;break;case e.POINTS:n.points+=a*s;break;default:Ot("WebGLInfo: Unknown draw mode:",o);break}}function r(){n.calls=0,n.triangles=0,n.points=0,n.lines=0}return{memory:t,render:n,programs:null,autoReset:!0,reset:r,update:i}}function WR(e,t,n){let i=new WeakMap,r=new we;function s(o,a,c){let l=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=i.get(a);if(f===void 0||f.count!==h){let R=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",R)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],S=0;d===!0&&(S=1),p===!0&&(S=2),_===!0&&(S=3);let v=a.attributes.position.count*S,w=1;v>t.maxTextureSize&&(w=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let b=new Float32Array(v*w*4*h),y=new ec(b,v,w,h);y.type=Mi,y.needsUpdate=!0;let M=S*4;for(let C=0;C<h;C++){let E=g[C],N=m[C],k=x[C],P=v*w*4*C;for(let L=0;L<E.count;L++){let B=L*M;d===!0&&(r.fromBufferAttribute(E,L),b[P+B+0]=r.x,b[P+B+1]=r.y,b[P+B+2]=r.z,b[P+B+3]=0),p===!0&&(r.fromBufferAttribute(N,L),b[P+B+4]=r.x,b[P+B+5]=r.y,b[P+B+6]=r.z,b[P+B+7]=0),_===!0&&(r.fromBufferAttribute(k,L),b[P+B+8]=r.x,b[P+B+9]=r.y,b[P+B+10]=r.z,b[P+B+11]=k.itemSize===4?r.w:1)}}f={count:h,texture:y,size:new Ft(v,w)},i.set(a,f),a.addEventListener("dispose",R)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(e,"morphTexture",o.morphTexture,n);else{let d=0;for(let _=0;_<l.length;_++)d+=l[_];let p=a.morphTargetsRelative?1:1-d;c.getUniforms().setValue(e,"morphTargetBaseInfluence",p),c.getUniforms().setValue(e,"morphTargetInfluences",l)}c.getUniforms().setValue(e,"morphTargetsTexture",f.texture,n),c.getUniforms().setValue(e,"morphTargetsTextureSize",f.size)}return{update:s}}function $R(e,t,n,i,r){let s=new WeakMap;function o(l){let u=r.render.frame,h=l.geometry,f=t.get(l,h);if(s.get(f)!==u&&(t.update(f),s.set(f,u)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),s.get(l)!==u&&(n.update(l.instanceMatrix,e.ARRAY_BUFFER),l.instanceColor!==null&&n.update(l.instanceColor,e.ARRAY_BUFFER),s.set(l,u))),l.isSkinnedMesh){let d=l.skeleton;s.get(d)!==u&&(d.update(),s.set(d,u))}return f}function a(){s=new WeakMap}function c(l){let u=l.target;u.removeEventListener("dispose",c),i.releaseStatesOfObject(u),n.remove(u.instanceMatrix),u.instanceColor!==null&&n.remove(u.instanceColor)}return{update:o,dispose:a}}var XR={[gp]:"LINEAR_TONE_MAPPING",[_p]:"REINHARD_TONE_MAPPING",[yp]:"CINEON_TONE_MAPPING",[xp]:"ACES_FILMIC_TONE_MAPPING",[bp]:"AGX_TONE_MAPPING",[Mp]:"NEUTRAL_TONE_MAPPING",[vp]:"CUSTOM_TONE_MAPPING"};function qR(e,t,n,i,r,s){let o=new Bn(t,n,{type:e,depthBuffer:r,stencilBuffer:s,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,u=new Kn;u.setAttribute("position",new rn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new rn([0,2,0,0,2,0],2));let h=new Su({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new jn(u,h),d=new gc(-1,1,1,-1,0,1),p=null,_=null,g=!1,m,x=null,S=[],v=!1;this.setSize=function(w,b){o.setSize(w,b),a!==null&&a.setSize(w,b),c!==null&&c.setSize(w,b);for(let y=0;y<S.length;y++){let M=S[y];M.setSize&&M.setSize(w,b)}},this.setEffects=function(w){S=w,v=S.length>0&&S[0].isRenderPass===!0;let b=o.width,y=o.height;S.length>0&&a===null&&(a=new Bn(b,y,{type:Si,depthBuffer:!1,stencilBuffer:!1}),c=new Bn(b,y,{type:Si,depthBuffer:!1,stencilBuffer:!1}));let M=r===!0&&S.some(R=>R.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&l===null&&(l=new _r(b,y),s===!0&&(l.format=xr,l.type=Ns)),o.dispose(),o.depthTexture=M?l:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let R=0;R<S.length;R++){let C=S[R];C.setSize&&C.setSize(b,y),M&&C.needsDepthTexture===!0&&C.setDepthTexture&&C.setDepthTexture(l)}},this.begin=function(w,b){if(g||w.toneMapping===Fi&&S.length===0)return!1;if(x=b,b!==null){let y=b.width,M=b.height;(o.width!==y||o.height!==M)&&this.setSize(y,M)}return v===!1&&w.setRenderTarget(o),m=w.toneMapping,w.toneMapping=Fi,!0},this.hasRenderPass=function(){return v},this.end=function(w,b){w.toneMapping=m,g=!0;let y=o,M=a;for(let R=0;R<S.length;R++){let C=S[R];C.enabled!==!1&&(C.render(w,M,y,b),C.needsSwap!==!1&&(y=M,M=M===a?c:a))}if(p!==w.outputColorSpace||_!==w.toneMapping){p=w.outputColorSpace,_=w.toneMapping,h.defines={},ne.getTransfer(p)===le&&(h.defines.SRGB_TRANSFER="");let R=XR[_];R&&(h.defines[R]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=y.texture,w.setRenderTarget(x),w.render(f,d),x=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),u.dispose(),h.dispose()}}var Vv=new An,Hv=new _r(1,1),Wv=new ac(1),$v=new ec,Xv=new yu,qv=new oc,bv=[],Mv=[],Sv=new Float32Array(16),wv=new Float32Array(9),Tv=new Float32Array(4);function $o(e,t,n){let i=e[0];if(i<=0||i>0)return e;let r=t*n,s=bv[r];if(s===void 0&&(s=new Float32Array(r),bv[r]=s),t!==0){i.toArray(s,0);for(let o=1,a=0;o!==t;++o)a+=n,e[o].toArray(s,a)}return s}function Fe(e,t){if(e.length!==t.length)return!1;for(let n=0,i=e.length;n<i;n++)if(e[n]!==t[n])return!1;return!0}function Oe(e,t){for(let n=0,i=t.length;n<i;n++)e[n]=t[n]}function If(e,t){let n=Mv[t];n===void 0&&(n=new Int32Array(t),Mv[t]=n);for(let i=0;i!==t;++i)n[i]=e.allocateTextureUnit();return n}function YR(e,t){let n=this.cache;n[0]!==t&&(e.uniform1f(this.addr,t),n[0]=t)}function ZR(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y)&&(e.uniform2f(this.addr,t.x,t.y),n[0]=t.x,n[1]=t.y);else{if(Fe(n,t))return;e.uniform2fv(this.addr,t),Oe(n,t)}}function JR(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z)&&(e.uniform3f(this.addr,t.x,t.y,t.z),n[0]=t.x,n[1]=t.y,n[2]=t.z);else if(t.r!==void 0)(n[0]!==t.r||n[1]!==t.g||n[2]!==t.b)&&(e.uniform3f(this.addr,t.r,t.g,t.b),n[0]=t.r,n[1]=t.g,n[2]=t.b);else{if(Fe(n,t))return;e.uniform3fv(this.addr,t),Oe(n,t)}}function KR(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z||n[3]!==t.w)&&(e.uniform4f(this.addr,t.x,t.y,t.z,t.w),n[0]=t.x,n[1]=t.y,n[2]=t.z,n[3]=t.w);else{if(Fe(n,t))return;e.uniform4fv(this.addr,t),Oe(n,t)}}function jR(e,t){let n=this.cache,i=t.elements;if(i===void 0){if(Fe(n,t))return;e.uniformMatrix2fv(this.addr,!1,t),Oe(n,t)}else{if(Fe(n,i))return;Tv.set(i),e.uniformMatrix2fv(this.addr,!1,Tv),Oe(n,i)}}function QR(e,t){let n=this.cache,i=t.elements;if(i===void 0){if(Fe(n,t))return;e.uniformMatrix3fv(this.addr,!1,t),Oe(n,t)}else{if(Fe(n,i))return;wv.set(i),e.uniformMatrix3fv(this.addr,!1,wv),Oe(n,i)}}function tP(e,t){let n=this.cache,i=t.elements;if(i===void 0){if(Fe(n,t))return;e.uniformMatrix4fv(this.addr,!1,t),Oe(n,t)}else{if(Fe(n,i))return;Sv.set(i),e.uniformMatrix4fv(this.addr,!1,Sv),Oe(n,i)}}function eP(e,t){let n=this.cache;n[0]!==t&&(e.uniform1i(this.addr,t),n[0]=t)}function nP(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y)&&(e.uniform2i(this.addr,t.x,t.y),n[0]=t.x,n[1]=t.y);else{if(Fe(n,t))return;e.uniform2iv(this.addr,t),Oe(n,t)}}function iP(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z)&&(e.uniform3i(this.addr,t.x,t.y,t.z),n[0]=t.x,n[1]=t.y,n[2]=t.z);else{if(Fe(n,t))return;e.uniform3iv(this.addr,t),Oe(n,t)}}function rP(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z||n[3]!==t.w)&&(e.uniform4i(this.addr,t.x,t.y,t.z,t.w),n[0]=t.x,n[1]=t.y,n[2]=t.z,n[3]=t.w);else{if(Fe(n,t))return;e.uniform4iv(this.addr,t),Oe(n,t)}}function sP(e,t){let n=this.cache;n[0]!==t&&(e.uniform1ui(this.addr,t),n[0]=t)}function oP(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y)&&(e.uniform2ui(this.addr,t.x,t.y),n[0]=t.x,n[1]=t.y);else{if(Fe(n,t))return;e.uniform2uiv(this.addr,t),Oe(n,t)}}function aP(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z)&&(e.uniform3ui(this.addr,t.x,t.y,t.z),n[0]=t.x,n[1]=t.y,n[2]=t.z);else{if(Fe(n,t))return;e.uniform3uiv(this.addr,t),Oe(n,t)}}function cP(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z||n[3]!==t.w)&&(e.uniform4ui(this.addr,t.x,t.y,t.z,t.w),n[0]=t.x,n[1]=t.y,n[2]=t.z,n[3]=t.w);else{if(Fe(n,t))return;e.uniform4uiv(this.addr,t),Oe(n,t)}}function Lf(e){return e.version===0&&(e.compareFunction=Np,e.needsUpdate=!0),e}function lP(e,t,n){let i=this.cache,r=n.allocateTextureUnit();i[0]!==r&&(e.uniform1i(this.addr,r),i[0]=r);let s;this.type===e.SAMPLER_2D_SHADOW?s=Lf(Hv):s=Vv,n.setTexture2D(t||s,r)}function uP(e,t,n){let i=this.cache,r=n.allocateTextureUnit();i[0]!==r&&(e.uniform1i(this.addr,r),i[0]=r),n.setTexture3D(t||Xv,r)}function fP(e,t,n){let i=this.cache,r=n.allocateTextureUnit();i[0]!==r&&(e.uniform1i(this.addr,r),i[0]=r);let s;this.type===e.SAMPLER_CUBE_SHADOW?s=Lf(Wv):s=qv,n.setTextureCube(t||s,r)}function hP(e,t,n){let i=this.cache,r=n.allocateTextureUnit();i[0]!==r&&(e.uniform1i(this.addr,r),i[0]=r),n.setTexture2DArray(t||$v,r)}function dP(e){switch(e){case 5126:return YR;case 35664:return ZR;case 35665:return JR;case 35666:return KR;case 35674:return jR;case 35675:return QR;case 35676:return tP;case 5124:case 35670:return eP;case 35667:case 35671:return nP;case 35668:case 35672:return iP;case 35669:case 35673:return rP;case 5125:return sP;case 36294:return oP;case 36295:return aP;case 36296:return cP;case 35678:case 36198:case 36298:case 36306:case 35682:return lP;case 35679:case 36299:case 36307:return uP;case 35680:case 36300:case 36308:case 36293:return fP;case 36289:case 36303:case 36311:case 36292:return hP}}function pP(e,t){e.uniform1fv(this.addr,t)}function mP(e,t){let n=$o(t,this.size,2);e.uniform2fv(this.addr,n)}function gP(e,t){let n=$o(t,this.size,3);e.uniform3fv(this.addr,n)}function _P(e,t){let n=$o(t,this.size,4);e.uniform4fv(this.addr,n)}function yP(e,t){let n=$o(t,this.size,4);e.uniformMatrix2fv(this.addr,!1,n)}function xP(e,t){let n=$o(t,this.size,9);e.uniformMatrix3fv(this.addr,!1,n)}function vP(e,t){let n=$o(t,this.size,16);e.uniformMatrix4fv(this.addr,!1,n)}function bP(e,t){e.uniform1iv(this.addr,t)}function MP(e,t){e.uniform2iv(this.addr,t)}function SP(e,t){e.uniform3iv(this.addr,t)}function wP(e,t){e.uniform4iv(this.addr,t)}function TP(e,t){e.uniform1uiv(this.addr,t)}function AP(e,t){e.uniform2uiv(this.addr,t)}function EP(e,t){e.uniform3uiv(this.addr,t)}function CP(e,t){e.uniform4uiv(this.addr,t)}function RP(e,t,n){let i=this.cache,r=t.length,s=If(n,r);Fe(i,s)||(e.uniform1iv(this.addr,s),Oe(i,s));let o;this.type===e.SAMPLER_2D_SHADOW?o=Lf(Hv):o=Vv;for(let a=0;a!==r;++a)n.setTexture2D(t[a]||o,s[a])}function PP(e,t,n){let i=this.cache,r=t.length,s=If(n,r);Fe(i,s)||(e.uniform1iv(this.addr,s),Oe(i,s));for(let o=0;o!==r;++o)n.setTexture3D(t[o]||Xv,s[o])}function IP(e,t,n){let i=this.cache,r=t.length,s=If(n,r);Fe(i,s)||(e.uniform1iv(this.addr,s),Oe(i,s));let o;this.type===e.SAMPLER_CUBE_SHADOW?o=Lf(Wv):o=qv;for(let a=0;a!==r;++a)n.setTextureCube(t[a]||o,s[a])}function LP(e,t,n){let i=this.cache,r=t.length,s=If(n,r);Fe(i,s)||(e.uniform1iv(this.addr,s),Oe(i,s));for(let o=0;o!==r;++o)n.setTexture2DArray(t[o]||$v,s[o])}function NP(e){switch(e){case 5126:return pP;case 35664:return mP;case 35665:return gP;case 35666:return _P;case 35674:return yP;case 35675:return xP;case 35676:return vP;case 5124:case 35670:return bP;case 35667:case 35671:return MP;case 35668:case 35672:return SP;case 35669:case 35673:return wP;case 5125:return TP;case 36294:return AP;case 36295:return EP;case 36296:return CP;case 35678:case 36198:case 36298:case 36306:case 35682:return RP;case 35679:case 36299:case 36307:return PP;case 35680:case 36300:case 36308:case 36293:return IP;case 36289:case 36303:case 36311:case 36292:return LP}}var Kp=class{constructor(t,n,i){this.id=t,this.addr=i,this.cache=[],this.type=n.type,this.setValue=dP(n.type)}},jp=class{constructor(t,n,i){this.id=t,this.addr=i,this.cache=[],this.type=n.type,this.size=n.size,this.setValue=NP(n.type)}},Qp=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,n,i){let r=this.seq;for(let s=0,o=r.length;s!==o;++s){let a=r[s];a.setValue(t,n[a.id],i)}}},Zp=/(\w+)(\])?(\[|\.)?/g;function Av(e,t){e.seq.push(t),e.map[t.id]=t}function DP(e,t,n){let i=e.name,r=i.length;for(Zp.lastIndex=0;;){let s=Zp.exec(i),o=Zp.lastIndex,a=s[1],c=s[2]==="]",l=s[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===r){Av(n,l===void 0?new Kp(a,e,t):new jp(a,e,t));break}else{let h=n.map[a];h===void 0&&(h=new Qp(a),Av(n,h)),n=h}}}var Wo=class{constructor(t,n){this.seq=[],this.map={};let i=t.getProgramParameter(n,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(n,o),c=t.getUniformLocation(n,a.name);DP(a,c,this)}let r=[],s=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?r.push(o):s.push(o);r.length>0&&(this.seq=r.concat(s))}setValue(t,n,i,r){let s=this.map[n];s!==void 0&&s.setValue(t,i,r)}setOptional(t,n,i){let r=n[i];r!==void 0&&this.setValue(t,i,r)}static upload(t,n,i,r){for(let s=0,o=n.length;s!==o;++s){let a=n[s],c=i[a.id];c.needsUpdate!==!1&&a.setValue(t,c.value,r)}}static seqWithValue(t,n){let i=[];for(let r=0,s=t.length;r!==s;++r){let o=t[r];o.id in n&&i.push(o)}return i}};function Ev(e,t,n){let i=e.createShader(t);return e.shaderSource(i,n),e.compileShader(i),i}var UP=37297,FP=0;function OP(e,t){let n=e.split(`
`),i=[],r=Math.max(t-6,0),s=Math.min(t+6,n.length);for(let o=r;o<s;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${n[o]}`)}return i.join(`
`)}var Cv=new kt;function BP(e){ne._getMatrix(Cv,ne.workingColorSpace,e);let t=`mat3( ${Cv.elements.map(n=>n.toFixed(4))} )`;switch(ne.getTransfer(e)){case Qa:return[t,"LinearTransferOETF"];case le:return[t,"sRGBTransferOETF"];default:return Dt("WebGLProgram: Unsupported color space: ",e),[t,"LinearTransferOETF"]}}function Rv(e,t,n){let i=e.getShaderParameter(t,e.COMPILE_STATUS),s=(e.getShaderInfoLog(t)||"").trim();if(i&&s==="")return"";let o=/ERROR: 0:(\d+)/.exec(s);if(o){let a=parseInt(o[1]);return n.toUpperCase()+`

`+s+`

`+OP(e.getShaderSource(t),a)}else return s}function kP(e,t){let n=BP(t);return[`vec4 ${e}( vec4 value ) {`,`	return ${n[1]}( vec4( ${n[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var zP={[gp]:"Linear",[_p]:"Reinhard",[yp]:"Cineon",[xp]:"ACESFilmic",[bp]:"AgX",[Mp]:"Neutral",[vp]:"Custom"};function GP(e,t){let n=zP[t];return n===void 0?(Dt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+e+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+e+"( vec3 color ) { return "+n+"ToneMapping( color ); }"}var Cf=new V;function VP(){ne.getLuminanceCoefficients(Cf);let e=Cf.x.toFixed(4),t=Cf.y.toFixed(4),n=Cf.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${e}, ${t}, ${n} );`,"	return dot( weights, rgb );","}"].join(`
`)}function HP(e){return[e.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",e.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Rc).join(`
`)}function WP(e){let t=[];for(let n in e){let i=e[n];i!==!1&&t.push("#define "+n+" "+i)}return t.join(`
`)}function $P(e,t){let n={},i=e.getProgramParameter(t,e.ACTIVE_ATTRIBUTES);for(let r=0;r<i;r++){let s=e.getActiveAttrib(t,r),o=s.name,a=1;s.type===e.FLOAT_MAT2&&(a=2),s.type===e.FLOAT_MAT3&&(a=3),s.type===e.FLOAT_MAT4&&(a=4),n[o]={type:s.type,location:e.getAttribLocation(t,o),locationSize:a}}return n}function Rc(e){return e!==""}function Pv(e,t){let n=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return e.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,n).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Iv(e,t){return e.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var XP=/^[ \t]*#include +<([\w\d./]+)>/gm;function tm(e){return e.replace(XP,qP)}function qP(e,t){let n=Zt[t];if(n===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return tm(n)}var YP=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Lv(e){return e.replace(YP,ZP)}function ZP(e,t,n,i){let r="";for(let s=parseInt(t);s<parseInt(n);s++)r+=i.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}function Nv(e){let t=`precision ${e.precision} float;
	precision ${e.precision} int;
	precision ${e.precision} sampler2D;
	precision ${e.precision} samplerCube;
	precision ${e.precision} sampler3D;
	precision ${e.precision} sampler2DArray;
	precision ${e.precision} sampler2DShadow;
	precision ${e.precision} samplerCubeShadow;
	precision ${e.precision} sampler2DArrayShadow;
	precision ${e.precision} isampler2D;
	precision ${e.precision} isampler3D;
	precision ${e.precision} isamplerCube;
	precision ${e.precision} isampler2DArray;
	precision ${e.precision} usampler2D;
	precision ${e.precision} usampler3D;
	precision ${e.precision} usamplerCube;
	precision ${e.precision} usampler2DArray;
	`;return e.precision==="highp"?t+=`
#define HIGH_PRECISION`:e.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:e.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var JP={[vc]:"SHADOWMAP_TYPE_PCF",[ko]:"SHADOWMAP_TYPE_VSM"};function KP(e){return JP[e.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var jP={[Go]:"ENVMAP_MODE_REFRACTION"};function QP(e){return e.envMap===!1?"ENVMAP_MODE_REFLECTION":jP[e.envMapMode]||"ENVMAP_MODE_REFLECTION"}var tI={[ku]:"ENVMAP_BLENDING_MULTIPLY",[Zx]:"ENVMAP_BLENDING_MIX",[Jx]:"ENVMAP_BLENDING_ADD"};function eI(e){return e.envMap===!1?"ENVMAP_BLENDING_NONE":tI[e.combine]||"ENVMAP_BLENDING_NONE"}function nI(e,t,n,i){let r=e.getContext(),s=n.defines,o=n.vertexShader,a=n.fragmentShader,c=KP(n),l=n.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=QP(n),h=eI(n),f=HP(n),d=WP(s),p=r.createProgram(),_,g,m=n.glslVersion?"#version "+n.glslVersion+`
`:"";n.isRawShaderMaterial?(_=["#define SHADER_TYPE "+n.shaderType,"#define SHADER_NAME "+n.shaderName,d].filter(Rc).join(`
`),_.length>0&&(_+=`
`),g=["#define SHADER_TYPE "+n.shaderType,"#define SHADER_NAME "+n.shaderName,d].filter(Rc).join(`
`),g.length>0&&(g+=`
`)):(_=[Nv(n),"#define SHADER_TYPE "+n.shaderType,"#define SHADER_NAME "+n.shaderName,d,n.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",n.batching?"#define USE_BATCHING":"",n.batchingColor?"#define USE_BATCHING_COLOR":"",n.instancing?"#define USE_INSTANCING":"",n.instancingColor?"#define USE_INSTANCING_COLOR":"",n.instancingMorph?"#define USE_INSTANCING_MORPH":"",n.useFog&&n.fog?"#define USE_FOG":"",n.useFog&&n.fogExp2?"#define FOG_EXP2":"",n.map?"#define USE_MAP":"",n.envMap?"#define USE_ENVMAP":"",n.envMap?"#define "+u:"",n.lightMap?"#define USE_LIGHTMAP":"",n.aoMap?"#define USE_AOMAP":"",n.bumpMap?"#define USE_BUMPMAP":"",n.normalMap?"#define USE_NORMALMAP":"",n.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",n.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",n.displacementMap?"#define USE_DISPLACEMENTMAP":"",n.emissiveMap?"#define USE_EMISSIVEMAP":"",n.anisotropy?"#define USE_ANISOTROPY":"",n.anisotropyMap?"#define USE_ANISOTROPYMAP":"",n.clearcoatMap?"#define USE_CLEARCOATMAP":"",n.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",n.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",n.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",n.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",n.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",n.specularMap?"#define USE_SPECULARMAP":"",n.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",n.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",n.roughnessMap?"#define USE_ROUGHNESSMAP":"",n.metalnessMap?"#define USE_METALNESSMAP":"",n.alphaMap?"#define USE_ALPHAMAP":"",n.alphaHash?"#define USE_ALPHAHASH":"",n.transmission?"#define USE_TRANSMISSION":"",n.transmissionMap?"#define USE_TRANSMISSIONMAP":"",n.thicknessMap?"#define USE_THICKNESSMAP":"",n.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",n.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",n.mapUv?"#define MAP_UV "+n.mapUv:"",n.alphaMapUv?"#define ALPHAMAP_UV "+n.alphaMapUv:"",n.lightMapUv?"#define LIGHTMAP_UV "+n.lightMapUv:"",n.aoMapUv?"#define AOMAP_UV "+n.aoMapUv:"",n.emissiveMapUv?"#define EMISSIVEMAP_UV "+n.emissiveMapUv:"",n.bumpMapUv?"#define BUMPMAP_UV "+n.bumpMapUv:"",n.normalMapUv?"#define NORMALMAP_UV "+n.normalMapUv:"",n.displacementMapUv?"#define DISPLACEMENTMAP_UV "+n.displacementMapUv:"",n.metalnessMapUv?"#define METALNESSMAP_UV "+n.metalnessMapUv:"",n.roughnessMapUv?"#define ROUGHNESSMAP_UV "+n.roughnessMapUv:"",n.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+n.anisotropyMapUv:"",n.clearcoatMapUv?"#define CLEARCOATMAP_UV "+n.clearcoatMapUv:"",n.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+n.clearcoatNormalMapUv:"",n.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+n.clearcoatRoughnessMapUv:"",n.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+n.diffuseRoughnessMapUv:"",n.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+n.iridescenceMapUv:"",n.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+n.iridescenceThicknessMapUv:"",n.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+n.sheenColorMapUv:"",n.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+n.sheenRoughnessMapUv:"",n.specularMapUv?"#define SPECULARMAP_UV "+n.specularMapUv:"",n.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+n.specularColorMapUv:"",n.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+n.specularIntensityMapUv:"",n.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+n.transmissionMapUv:"",n.thicknessMapUv?"#define THICKNESSMAP_UV "+n.thicknessMapUv:"",n.vertexTangents&&n.flatShading===!1?"#define USE_TANGENT":"",n.vertexNormals?"#define HAS_NORMAL":"",n.vertexColors?"#define USE_COLOR":"",n.vertexAlphas?"#define USE_COLOR_ALPHA":"",n.vertexUv1s?"#define USE_UV1":"",n.vertexUv2s?"#define USE_UV2":"",n.vertexUv3s?"#define USE_UV3":"",n.pointsUvs?"#define USE_POINTS_UV":"",n.flatShading?"#define FLAT_SHADED":"",n.skinning?"#define USE_SKINNING":"",n.morphTargets?"#define USE_MORPHTARGETS":"",n.morphNormals&&n.flatShading===!1?"#define USE_MORPHNORMALS":"",n.morphColors?"#define USE_MORPHCOLORS":"",n.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+n.morphTextureStride:"",n.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+n.morphTargetsCount:"",n.doubleSided?"#define DOUBLE_SIDED":"",n.flipSided?"#define FLIP_SIDED":"",n.shadowMapEnabled?"#define USE_SHADOWMAP":"",n.shadowMapEnabled?"#define "+c:"",n.sizeAttenuation?"#define USE_SIZEATTENUATION":"",n.numLightProbes>0?"#define USE_LIGHT_PROBES":"",n.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",n.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Rc).join(`
`),g=[Nv(n),"#define SHADER_TYPE "+n.shaderType,"#define SHADER_NAME "+n.shaderName,d,n.useFog&&n.fog?"#define USE_FOG":"",n.useFog&&n.fogExp2?"#define FOG_EXP2":"",n.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",n.map?"#define USE_MAP":"",n.matcap?"#define USE_MATCAP":"",n.envMap?"#define USE_ENVMAP":"",n.envMap?"#define "+l:"",n.envMap?"#define "+u:"",n.envMap?"#define "+h:"",n.envMapPMREM?"#define ENVMAP_MAX_LOD "+n.envMapMaxLod+".0":"",n.envMapPMREM?"#define ENVMAP_SIZE "+n.envMapSize+".0":"",n.lightMap?"#define USE_LIGHTMAP":"",n.aoMap?"#define USE_AOMAP":"",n.bumpMap?"#define USE_BUMPMAP":"",n.normalMap?"#define USE_NORMALMAP":"",n.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",n.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",n.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",n.emissiveMap?"#define USE_EMISSIVEMAP":"",n.anisotropy?"#define USE_ANISOTROPY":"",n.anisotropyMap?"#define USE_ANISOTROPYMAP":"",n.clearcoat?"#define USE_CLEARCOAT":"",n.clearcoatMap?"#define USE_CLEARCOATMAP":"",n.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",n.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",n.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",n.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",n.dispersion?"#define USE_DISPERSION":"",n.retroreflection?"#define USE_RETROREFLECTION":"",n.iridescence?"#define USE_IRIDESCENCE":"",n.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",n.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",n.specularMap?"#define USE_SPECULARMAP":"",n.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",n.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",n.roughnessMap?"#define USE_ROUGHNESSMAP":"",n.metalnessMap?"#define USE_METALNESSMAP":"",n.alphaMap?"#define USE_ALPHAMAP":"",n.alphaTest?"#define USE_ALPHATEST":"",n.alphaHash?"#define USE_ALPHAHASH":"",n.sheen?"#define USE_SHEEN":"",n.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",n.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",n.transmission?"#define USE_TRANSMISSION":"",n.transmissionMap?"#define USE_TRANSMISSIONMAP":"",n.thicknessMap?"#define USE_THICKNESSMAP":"",n.vertexTangents&&n.flatShading===!1?"#define USE_TANGENT":"",n.vertexColors||n.instancingColor?"#define USE_COLOR":"",n.vertexAlphas||n.batchingColor?"#define USE_COLOR_ALPHA":"",n.vertexUv1s?"#define USE_UV1":"",n.vertexUv2s?"#define USE_UV2":"",n.vertexUv3s?"#define USE_UV3":"",n.pointsUvs?"#define USE_POINTS_UV":"",n.gradientMap?"#define USE_GRADIENTMAP":"",n.flatShading?"#define FLAT_SHADED":"",n.doubleSided?"#define DOUBLE_SIDED":"",n.flipSided?"#define FLIP_SIDED":"",n.shadowMapEnabled?"#define USE_SHADOWMAP":"",n.shadowMapEnabled?"#define "+c:"",n.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",n.numLightProbes>0?"#define USE_LIGHT_PROBES":"",n.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",n.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",n.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",n.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",n.toneMapping!==Fi?"#define TONE_MAPPING":"",n.toneMapping!==Fi?Zt.tonemapping_pars_fragment:"",n.toneMapping!==Fi?GP("toneMapping",n.toneMapping):"",n.dithering?"#define DITHERING":"",n.opaque?"#define OPAQUE":"",Zt.colorspace_pars_fragment,kP("linearToOutputTexel",n.outputColorSpace),VP(),n.useDepthPacking?"#define DEPTH_PACKING "+n.depthPacking:"",`
`].filter(Rc).join(`
`)),o=tm(o),o=Pv(o,n),o=Iv(o,n),a=tm(a),a=Pv(a,n),a=Iv(a,n),o=Lv(o),a=Lv(a),n.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,_=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,g=["#define varying in",n.glslVersion===Dp?"":"layout(location = 0) out highp vec4 pc_fragColor;",n.glslVersion===Dp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let x=m+_+o,S=m+g+a,v=Ev(r,r.VERTEX_SHADER,x),w=Ev(r,r.FRAGMENT_SHADER,S);r.attachShader(p,v),r.attachShader(p,w),n.index0AttributeName!==void 0?r.bindAttribLocation(p,0,n.index0AttributeName):n.hasPositionAttribute===!0&&r.bindAttribLocation(p,0,"position"),r.linkProgram(p);function b(C){if(e.debug.checkShaderErrors){let E=r.getProgramInfoLog(p)||"",N=r.getShaderInfoLog(v)||"",k=r.getShaderInfoLog(w)||"",P=E.trim(),L=N.trim(),B=k.trim(),U=!0,Z=!0;if(r.getProgramParameter(p,r.LINK_STATUS)===!1)if(U=!1,typeof e.debug.onShaderError=="function")e.debug.onShaderError(r,p,v,w);else{let F=Rv(r,v,"vertex"),G=Rv(r,w,"fragment");Ot("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(p,r.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+P+`
`+F+`
`+G)}else P!==""?Dt("WebGLProgram: Program Info Log:",P):(L===""||B==="")&&(Z=!1);Z&&(C.diagnostics={runnable:U,programLog:P,vertexShader:{log:L,prefix:_},fragmentShader:{log:B,prefix:g}})}r.deleteShader(v),r.deleteShader(w),y=new Wo(r,p),M=$P(r,p)}let y;this.getUniforms=function(){return y===void 0&&b(this),y};let M;this.getAttributes=function(){return M===void 0&&b(this),M};let R=n.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return R===!1&&(R=r.getProgramParameter(p,UP)),R},this.destroy=function(){i.releaseStatesOfProgram(this),r.deleteProgram(p),this.program=void 0},this.type=n.shaderType,this.name=n.shaderName,this.id=FP++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=v,this.fragmentShader=w,this}var iI=0,em=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,n,i){let r=this._getShaderCacheForMaterial(t);return r.has(n)===!1&&(r.add(n),n.usedTimes++),r.has(i)===!1&&(r.add(i),i.usedTimes++),this}remove(t){let n=this.materialCache.get(t);for(let i of n)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let n=this.materialCache,i=n.get(t);return i===void 0&&(i=new Set,n.set(t,i)),i}_getShaderStage(t){let n=this.shaderCache,i=n.get(t);return i===void 0&&(i=new nm(t),n.set(t,i)),i}},nm=class{constructor(t){this.id=iI++,this.code=t,this.usedTimes=0}};function rI(e){return e===ns||e===Ac||e===Ec}function sI(e,t,n,i,r,s){let o=new Lo,a=new em,c=new Set,l=[],u=new Map,h=i.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(y){return c.add(y),y===0?"uv":`uv${y}`}function p(y,M,R,C,E,N){let k=C.fog,P=E.geometry,L=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?C.environment:null,B=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,U=t.get(y.envMap||L,B),Z=f[y.type],F=i.precision;y.precision!==null&&(F=i.getMaxPrecision(y.precision),F!==y.precision&&Dt("WebGLProgram.getParameters:",y.precision,"not supported, using",F,"instead."));let G=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,q=G!==void 0?G.length:0,rt=0;P.morphAttributes.position!==void 0&&(rt=1),P.morphAttributes.normal!==void 0&&(rt=2),P.morphAttributes.color!==void 0&&(rt=3);let ct,$,ot,ut;if(Z){let wt=Bi[Z];ct=wt.vertexShader,$=wt.fragmentShader}else{ct=y.vertexShader,$=y.fragmentShader;let wt=a.getVertexShaderStage(y),fe=a.getFragmentShaderStage(y);a.update(y,wt,fe),ot=wt.id,ut=fe.id}let st=e.getRenderTarget(),at=e.state.buffers.depth.getReversed(),J=E.isInstancedMesh===!0,yt=E.isBatchedMesh===!0,lt=!!y.map,K=!!y.matcap,Lt=!!U,Mt=Lt&&U.isPMREMTexture===!0,Vt=!!y.aoMap,Xt=!!y.lightMap,he=!!y.bumpMap&&y.wireframe===!1,ce=!!y.normalMap,un=!!y.displacementMap,We=!!y.emissiveMap,Wn=!!y.metalnessMap,$n=!!y.roughnessMap,Xn=y.anisotropy>0,z=y.clearcoat>0,qn=y.diffuseRoughness>0,Me=y.dispersion>0,Se=y.retroreflectivity>0,St=y.iridescence>0,Ue=y.sheen>0,Ut=y.transmission>0,zt=Xn&&!!y.anisotropyMap,I=z&&!!y.clearcoatMap,T=z&&!!y.clearcoatNormalMap,W=z&&!!y.clearcoatRoughnessMap,ft=qn&&!!y.diffuseRoughnessMap,nt=St&&!!y.iridescenceMap,pt=St&&!!y.iridescenceThicknessMap,vt=Ue&&!!y.sheenColorMap,Q=Ue&&!!y.sheenRoughnessMap,tt=!!y.specularMap,gt=!!y.specularColorMap,D=!!y.specularIntensityMap,et=Ut&&!!y.transmissionMap,j=Ut&&!!y.thicknessMap,_t=!!y.gradientMap,dt=!!y.alphaMap,mt=y.alphaTest>0,It=!!y.alphaHash,Yt=!!y.extensions,ht=Fi;y.toneMapped&&(st===null||st.isXRRenderTarget===!0)&&(ht=e.toneMapping);let Nt=Mt?U.isCompressedCubeTexture?U.image[0].mipmaps:U.mipmaps:null,qt={shaderID:Z,shaderType:y.type,shaderName:y.name,vertexShader:ct,fragmentShader:$,defines:y.defines,customVertexShaderID:ot,customFragmentShaderID:ut,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:F,batching:yt,batchingColor:yt&&E._colorsTexture!==null,instancing:J,instancingColor:J&&E.instanceColor!==null,instancingMorph:J&&E.morphTexture!==null,outputColorSpace:st===null?e.outputColorSpace:st.isXRRenderTarget===!0?st.texture.colorSpace:ne.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:lt,matcap:K,envMap:Lt,envMapMode:Lt&&U.mapping,envMapPMREM:Mt,envMapMaxLod:Mt?Nt.length-1:null,envMapSize:Mt?Nt[0].width:null,aoMap:Vt,lightMap:Xt,bumpMap:he,normalMap:ce,displacementMap:un,emissiveMap:We,normalMapObjectSpace:ce&&y.normalMapType===Qx,normalMapTangentSpace:ce&&y.normalMapType===Af,packedNormalMap:ce&&y.normalMapType===Af&&rI(y.normalMap.format),metalnessMap:Wn,roughnessMap:$n,anisotropy:Xn,anisotropyMap:zt,clearcoat:z,clearcoatMap:I,clearcoatNormalMap:T,clearcoatRoughnessMap:W,diffuseRoughness:qn,diffuseRoughnessMap:ft,dispersion:Me,retroreflection:Se,iridescence:St,iridescenceMap:nt,iridescenceThicknessMap:pt,sheen:Ue,sheenColorMap:vt,sheenRoughnessMap:Q,specularMap:tt,specularColorMap:gt,specularIntensityMap:D,transmission:Ut,transmissionMap:et,thicknessMap:j,gradientMap:_t,opaque:y.transparent===!1&&y.blending===zo&&y.alphaToCoverage===!1,alphaMap:dt,alphaTest:mt,alphaHash:It,combine:y.combine,mapUv:lt&&d(y.map.channel),aoMapUv:Vt&&d(y.aoMap.channel),lightMapUv:Xt&&d(y.lightMap.channel),bumpMapUv:he&&d(y.bumpMap.channel),normalMapUv:ce&&d(y.normalMap.channel),displacementMapUv:un&&d(y.displacementMap.channel),emissiveMapUv:We&&d(y.emissiveMap.channel),metalnessMapUv:Wn&&d(y.metalnessMap.channel),roughnessMapUv:$n&&d(y.roughnessMap.channel),anisotropyMapUv:zt&&d(y.anisotropyMap.channel),clearcoatMapUv:I&&d(y.clearcoatMap.channel),clearcoatNormalMapUv:T&&d(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:W&&d(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ft&&d(y.diffuseRoughnessMap.channel),iridescenceMapUv:nt&&d(y.iridescenceMap.channel),iridescenceThicknessMapUv:pt&&d(y.iridescenceThicknessMap.channel),sheenColorMapUv:vt&&d(y.sheenColorMap.channel),sheenRoughnessMapUv:Q&&d(y.sheenRoughnessMap.channel),specularMapUv:tt&&d(y.specularMap.channel),specularColorMapUv:gt&&d(y.specularColorMap.channel),specularIntensityMapUv:D&&d(y.specularIntensityMap.channel),transmissionMapUv:et&&d(y.transmissionMap.channel),thicknessMapUv:j&&d(y.thicknessMap.channel),alphaMapUv:dt&&d(y.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(ce||Xn),vertexNormals:!!P.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:E.isPoints===!0&&!!P.attributes.uv&&(lt||dt),fog:!!k,useFog:y.fog===!0,fogExp2:!!k&&k.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||P.attributes.normal===void 0&&ce===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:at,skinning:E.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:q,morphTextureStride:rt,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:N.filter(wt=>wt.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:y.dithering,shadowMapEnabled:e.shadowMap.enabled&&R.length>0,shadowMapType:e.shadowMap.type,toneMapping:ht,decodeVideoTexture:lt&&y.map.isVideoTexture===!0&&ne.getTransfer(y.map.colorSpace)===le,decodeVideoTextureEmissive:We&&y.emissiveMap.isVideoTexture===!0&&ne.getTransfer(y.emissiveMap.colorSpace)===le,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===Ui,flipSided:y.side===an,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:Yt&&y.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Yt&&y.extensions.multiDraw===!0||yt)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return qt.vertexUv1s=c.has(1),qt.vertexUv2s=c.has(2),qt.vertexUv3s=c.has(3),c.clear(),qt}function _(y){let M=[];if(y.shaderID?M.push(y.shaderID):(M.push(y.customVertexShaderID),M.push(y.customFragmentShaderID)),y.defines!==void 0)for(let R in y.defines)M.push(R),M.push(y.defines[R]);return y.isRawShaderMaterial===!1&&(g(M,y),m(M,y),M.push(e.outputColorSpace)),M.push(y.customProgramCacheKey),M.join()}function g(y,M){y.push(M.precision),y.push(M.outputColorSpace),y.push(M.envMapMode),y.push(M.envMapPMREM),y.push(M.envMapMaxLod),y.push(M.envMapSize),y.push(M.mapUv),y.push(M.alphaMapUv),y.push(M.lightMapUv),y.push(M.aoMapUv),y.push(M.bumpMapUv),y.push(M.normalMapUv),y.push(M.displacementMapUv),y.push(M.emissiveMapUv),y.push(M.metalnessMapUv),y.push(M.roughnessMapUv),y.push(M.anisotropyMapUv),y.push(M.clearcoatMapUv),y.push(M.clearcoatNormalMapUv),y.push(M.clearcoatRoughnessMapUv),y.push(M.diffuseRoughnessMapUv),y.push(M.iridescenceMapUv),y.push(M.iridescenceThicknessMapUv),y.push(M.sheenColorMapUv),y.push(M.sheenRoughnessMapUv),y.push(M.specularMapUv),y.push(M.specularColorMapUv),y.push(M.specularIntensityMapUv),y.push(M.transmissionMapUv),y.push(M.thicknessMapUv),y.push(M.combine),y.push(M.fogExp2),y.push(M.sizeAttenuation),y.push(M.morphTargetsCount),y.push(M.numSunLights),y.push(M.numDirLights),y.push(M.numPointLights),y.push(M.numSpotLights),y.push(M.numSpotLightMaps),y.push(M.numHemiLights),y.push(M.numRectAreaLights),y.push(M.numSunLightShadows),y.push(M.numDirLightShadows),y.push(M.numPointLightShadows),y.push(M.numSpotLightShadows),y.push(M.numSpotLightShadowsWithMaps),y.push(M.numLightProbes),y.push(M.numLightProbeGrids),y.push(M.shadowMapType),y.push(M.toneMapping),y.push(M.numClippingPlanes),y.push(M.numClipIntersection),y.push(M.depthPacking)}function m(y,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function x(y){let M=f[y.type],R;if(M){let C=Bi[M];R=pv.clone(C.uniforms)}else R=y.uniforms;return R}function S(y,M){let R=u.get(M);return R!==void 0?++R.usedTimes:(R=new nI(e,M,y,r),l.push(R),u.set(M,R)),R}function v(y){if(--y.usedTimes===0){let M=l.indexOf(y);l[M]=l[l.length-1],l.pop(),u.delete(y.cacheKey),y.destroy()}}function w(y){a.remove(y)}function b(){a.dispose()}return{getParameters:p,getProgramCacheKey:_,getUniforms:x,acquireProgram:S,releaseProgram:v,releaseShaderCache:w,programs:l,dispose:b}}function oI(){let e=new WeakMap;function t(o){return e.has(o)}function n(o){let a=e.get(o);return a===void 0&&(a={},e.set(o,a)),a}function i(o){e.delete(o)}function r(o,a,c){e.get(o)[a]=c}function s(){e=new WeakMap}return{has:t,get:n,remove:i,update:r,dispose:s}}function aI(e,t){return e.groupOrder!==t.groupOrder?e.groupOrder-t.groupOrder:e.renderOrder!==t.renderOrder?e.renderOrder-t.renderOrder:e.material.id!==t.material.id?e.material.id-t.material.id:e.materialVariant!==t.materialVariant?e.materialVariant-t.materialVariant:e.z!==t.z?e.z-t.z:e.id-t.id}function Dv(e,t){return e.groupOrder!==t.groupOrder?e.groupOrder-t.groupOrder:e.renderOrder!==t.renderOrder?e.renderOrder-t.renderOrder:e.z!==t.z?t.z-e.z:e.id-t.id}function Uv(){let e=[],t=0,n=[],i=[],r=[];function s(){t=0,n.length=0,i.length=0,r.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,p,_,g,m){let x=e[t];return x===void 0?(x={id:f.id,object:f,geometry:d,material:p,materialVariant:o(f),groupOrder:_,renderOrder:f.renderOrder,z:g,group:m},e[t]=x):(x.id=f.id,x.object=f,x.geometry=d,x.material=p,x.materialVariant=o(f),x.groupOrder=_,x.renderOrder=f.renderOrder,x.z=g,x.group=m),t++,x}function c(f,d,p,_,g,m,x){x.reversedDepth===!0&&(g=-g);let S=a(f,d,p,_,g,m);p.transmission>0?i.push(S):p.transparent===!0?r.push(S):n.push(S)}function l(f,d,p,_,g,m){let x=a(f,d,p,_,g,m);p.transmission>0?i.unshift(x):p.transparent===!0?r.unshift(x):n.unshift(x)}function u(f,d){n.length>1&&n.sort(f||aI),i.length>1&&i.sort(d||Dv),r.length>1&&r.sort(d||Dv)}function h(){for(let f=t,d=e.length;f<d;f++){let p=e[f];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:n,transmissive:i,transparent:r,init:s,push:c,unshift:l,finish:h,sort:u}}function cI(){let e=new WeakMap;function t(i,r){let s=e.get(i),o;return s===void 0?(o=new Uv,e.set(i,[o])):r>=s.length?(o=new Uv,s.push(o)):o=s[r],o}function n(){e=new WeakMap}return{get:t,dispose:n}}function lI(){let e={};return{get:function(t){if(e[t.id]!==void 0)return e[t.id];let n;switch(t.type){case"SunLight":case"DirectionalLight":n={direction:new V,color:new jt};break;case"SpotLight":n={position:new V,direction:new V,color:new jt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":n={position:new V,color:new jt,distance:0,decay:0};break;case"HemisphereLight":n={direction:new V,skyColor:new jt,groundColor:new jt};break;case"RectAreaLight":n={color:new jt,position:new V,halfWidth:new V,halfHeight:new V};break}return e[t.id]=n,n}}}function uI(){let e={};return{get:function(t){if(e[t.id]!==void 0)return e[t.id];let n;switch(t.type){case"SunLight":case"DirectionalLight":n={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ft};break;case"SpotLight":n={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ft};break;case"PointLight":n={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ft,shadowCameraNear:1,shadowCameraFar:1e3};break}return e[t.id]=n,n}}}var fI=0;function hI(e,t){return(t.castShadow?2:0)-(e.castShadow?2:0)+(t.map?1:0)-(e.map?1:0)}function dI(e){let t=new lI,n=uI(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)i.probe.push(new V);let r=new V,s=new de,o=new de;function a(l){let u=0,h=0,f=0;for(let N=0;N<9;N++)i.probe[N].set(0,0,0);let d=0,p=0,_=0,g=0,m=0,x=0,S=0,v=0,w=0,b=0,y=0,M=0,R=0,C=0;l.sort(hI);for(let N=0,k=l.length;N<k;N++){let P=l[N],L=P.color,B=P.intensity,U=P.distance,Z=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===ns?Z=P.shadow.map.texture:Z=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)u+=L.r*B,h+=L.g*B,f+=L.b*B;else if(P.isLightProbe){for(let F=0;F<9;F++)i.probe[F].addScaledVector(P.sh.coefficients[F],B);C++}else if(P.isSunLight){let F=t.get(P);if(F.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let G=P.shadow,q=n.get(P);q.shadowIntensity=G.intensity,q.shadowBias=G.bias,q.shadowNormalBias=G.normalBias,q.shadowRadius=G.radius,q.shadowMapSize.copy(G.mapSize).multiply(G.getFrameExtents()),i.sunShadow[p]=q,i.sunShadowMap[p]=Z;let rt=G.getViewportCount();for(let ct=0;ct<rt;ct++)i.sunShadowMatrix[_+ct]=G.getMatrix(ct),i.sunShadowCascade[_+ct]=G._cascadeData[ct];_+=rt,p++}i.sun[d]=F,d++}else if(P.isDirectionalLight){let F=t.get(P);if(F.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let G=P.shadow,q=n.get(P);q.shadowIntensity=G.intensity,q.shadowBias=G.bias,q.shadowNormalBias=G.normalBias,q.shadowRadius=G.radius,q.shadowMapSize=G.mapSize,i.directionalShadow[g]=q,i.directionalShadowMap[g]=Z,i.directionalShadowMatrix[g]=P.shadow.matrix,w++}i.directional[g]=F,g++}else if(P.isSpotLight){let F=t.get(P);F.position.setFromMatrixPosition(P.matrixWorld),F.color.copy(L).multiplyScalar(B),F.distance=U,F.coneCos=Math.cos(P.angle),F.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),F.decay=P.decay,i.spot[x]=F;let G=P.shadow;if(P.map&&(i.spotLightMap[M]=P.map,M++,G.updateMatrices(P),P.castShadow&&R++),i.spotLightMatrix[x]=G.matrix,P.castShadow){let q=n.get(P);q.shadowIntensity=G.intensity,q.shadowBias=G.bias,q.shadowNormalBias=G.normalBias,q.shadowRadius=G.radius,q.shadowMapSize=G.mapSize,i.spotShadow[x]=q,i.spotShadowMap[x]=Z,y++}x++}else if(P.isRectAreaLight){let F=t.get(P);F.color.copy(L).multiplyScalar(B),F.halfWidth.set(P.width*.5,0,0),F.halfHeight.set(0,P.height*.5,0),i.rectArea[S]=F,S++}else if(P.isPointLight){let F=t.get(P);if(F.color.copy(P.color).multiplyScalar(P.intensity),F.distance=P.distance,F.decay=P.decay,P.castShadow){let G=P.shadow,q=n.get(P);q.shadowIntensity=G.intensity,q.shadowBias=G.bias,q.shadowNormalBias=G.normalBias,q.shadowRadius=G.radius,q.shadowMapSize=G.mapSize,q.shadowCameraNear=G.camera.near,q.shadowCameraFar=G.camera.far,i.pointShadow[m]=q,i.pointShadowMap[m]=Z,i.pointShadowMatrix[m]=P.shadow.matrix,b++}i.point[m]=F,m++}else if(P.isHemisphereLight){let F=t.get(P);F.skyColor.copy(P.color).multiplyScalar(B),F.groundColor.copy(P.groundColor).multiplyScalar(B),i.hemi[v]=F,v++}}S>0&&(e.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Tt.LTC_FLOAT_1,i.rectAreaLTC2=Tt.LTC_FLOAT_2):(i.rectAreaLTC1=Tt.LTC_HALF_1,i.rectAreaLTC2=Tt.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;let E=i.hash;(E.sunLength!==d||E.directionalLength!==g||E.pointLength!==m||E.spotLength!==x||E.rectAreaLength!==S||E.hemiLength!==v||E.numSunShadows!==p||E.numDirectionalShadows!==w||E.numPointShadows!==b||E.numSpotShadows!==y||E.numSpotMaps!==M||E.numLightProbes!==C)&&(i.sun.length=d,i.directional.length=g,i.spot.length=x,i.rectArea.length=S,i.point.length=m,i.hemi.length=v,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=_,i.sunShadowCascade.length=_,i.directionalShadow.length=w,i.directionalShadowMap.length=w,i.directionalShadowMatrix.length=w,i.pointShadow.length=b,i.pointShadowMap.length=b,i.pointShadowMatrix.length=b,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+M-R,i.spotLightMap.length=M,i.numSpotLightShadowsWithMaps=R,i.numLightProbes=C,E.sunLength=d,E.directionalLength=g,E.pointLength=m,E.spotLength=x,E.rectAreaLength=S,E.hemiLength=v,E.numSunShadows=p,E.numDirectionalShadows=w,E.numPointShadows=b,E.numSpotShadows=y,E.numSpotMaps=M,E.numLightProbes=C,i.version=fI++)}function c(l,u){let h=0,f=0,d=0,p=0,_=0,g=0,m=u.matrixWorldInverse;for(let x=0,S=l.length;x<S;x++){let v=l[x];if(v.isSunLight){let w=i.sun[h];w.direction.setFromMatrixPosition(v.matrixWorld),w.direction.transformDirection(m),h++}else if(v.isDirectionalLight){let w=i.directional[f];w.direction.setFromMatrixPosition(v.matrixWorld),r.setFromMatrixPosition(v.target.matrixWorld),w.direction.sub(r),w.direction.transformDirection(m),f++}else if(v.isSpotLight){let w=i.spot[p];w.position.setFromMatrixPosition(v.matrixWorld),w.position.applyMatrix4(m),w.direction.setFromMatrixPosition(v.matrixWorld),r.setFromMatrixPosition(v.target.matrixWorld),w.direction.sub(r),w.direction.transformDirection(m),p++}else if(v.isRectAreaLight){let w=i.rectArea[_];w.position.setFromMatrixPosition(v.matrixWorld),w.position.applyMatrix4(m),o.identity(),s.copy(v.matrixWorld),s.premultiply(m),o.extractRotation(s),w.halfWidth.set(v.width*.5,0,0),w.halfHeight.set(0,v.height*.5,0),w.halfWidth.applyMatrix4(o),w.halfHeight.applyMatrix4(o),_++}else if(v.isPointLight){let w=i.point[d];w.position.setFromMatrixPosition(v.matrixWorld),w.position.applyMatrix4(m),d++}else if(v.isHemisphereLight){let w=i.hemi[g];w.direction.setFromMatrixPosition(v.matrixWorld),w.direction.transformDirection(m),g++}}}return{setup:a,setupView:c,state:i}}function Fv(e){let t=new dI(e),n=[],i=[],r=[];function s(h){u.camera=h,n.length=0,i.length=0,r.length=0}function o(h){h.isLightProbeGrid?r.push(h):n.push(h)}function a(h){i.push(h)}function c(){t.setup(n),r.sort((h,f)=>h.priority-f.priority||h.id-f.id)}function l(h){t.setupView(n,h)}let u={lightsArray:n,shadowsArray:i,lightProbeGridArray:r,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:u,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function pI(e){let t=new WeakMap;function n(r,s=0){let o=t.get(r),a;return o===void 0?(a=new Fv(e),t.set(r,[a])):s>=o.length?(a=new Fv(e),o.push(a)):a=o[s],a}function i(){t=new WeakMap}return{get:n,dispose:i}}var mI=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,gI=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,_I=[new V(1,0,0),new V(-1,0,0),new V(0,1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1)],yI=[new V(0,-1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1),new V(0,-1,0),new V(0,-1,0)],Ov=new de,Cc=new V,Jp=new V;function xI(e,t,n){let i=new Zr,r=new Ft,s=new Ft,o=new we,a=new wu,c=new Tu,l={},u=n.maxTextureSize,h={[Di]:an,[an]:Di,[Ui]:Ui},f=new Ni({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ft},radius:{value:4}},vertexShader:mI,fragmentShader:gI}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let p=new Kn;p.setAttribute("position",new Jn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new jn(p,f),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=vc;let m=this.type;this.render=function(b,y,M){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||b.length===0)return;this.type===Px&&(Dt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=vc);let R=e.getRenderTarget(),C=e.getActiveCubeFace(),E=e.getActiveMipmapLevel(),N=e.state;N.setBlending(Ps),N.buffers.depth.getReversed()===!0?N.buffers.color.setClear(0,0,0,0):N.buffers.color.setClear(1,1,1,1),N.buffers.depth.setTest(!0),N.setScissorTest(!1);let k=m!==this.type;k&&y.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(L=>L.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,L=b.length;P<L;P++){let B=b[P],U=B.shadow;if(U===void 0){Dt("WebGLShadowMap:",B,"has no shadow.");continue}if(U.autoUpdate===!1&&U.needsUpdate===!1)continue;r.copy(U.mapSize);let Z=U.getFrameExtents();r.multiply(Z),s.copy(U.mapSize),(r.x>u||r.y>u)&&(r.x>u&&(s.x=Math.floor(u/Z.x),r.x=s.x*Z.x,U.mapSize.x=s.x),r.y>u&&(s.y=Math.floor(u/Z.y),r.y=s.y*Z.y,U.mapSize.y=s.y));let F=e.state.buffers.depth.getReversed();if(U.camera._reversedDepth=F,U.map===null||k===!0){if(U.map!==null&&(U.map.depthTexture!==null&&(U.map.depthTexture.dispose(),U.map.depthTexture=null),U.map.dispose()),this.type===ko){if(B.isPointLight){Dt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}U.map=new Bn(r.x,r.y,{format:ns,type:Si,minFilter:sn,magFilter:sn,generateMipmaps:!1}),U.map.texture.name=B.name+".shadowMap",U.map.depthTexture=new _r(r.x,r.y,Mi),U.map.depthTexture.name=B.name+".shadowMapDepth",U.map.depthTexture.format=pr,U.map.depthTexture.compareFunction=null,U.map.depthTexture.minFilter=Ye,U.map.depthTexture.magFilter=Ye}else B.isPointLight?(U.map=new Pc(r.x),U.map.depthTexture=new ac(r.x,bi)):(U.map=new Bn(r.x,r.y),U.map.depthTexture=new _r(r.x,r.y,bi)),U.map.depthTexture.name=B.name+".shadowMap",U.map.depthTexture.format=pr,this.type===vc?(U.map.depthTexture.compareFunction=F?Lp:Ip,U.map.depthTexture.minFilter=sn,U.map.depthTexture.magFilter=sn):(U.map.depthTexture.compareFunction=null,U.map.depthTexture.minFilter=Ye,U.map.depthTexture.magFilter=Ye);U.camera.updateProjectionMatrix()}U.map.isWebGLCubeRenderTarget!==!0&&(U.map.width!==r.x||U.map.height!==r.y)&&U.map.setSize(r.x,r.y);let G=U.map.isWebGLCubeRenderTarget?6:U.getViewportCount();B.isPointLight!==!0&&U.updateMatrices(B,M);let q=(U.camera.layers.mask&4294967294)!==0?U.camera.layers:M.layers;for(let rt=0;rt<G;rt++){let ct=U.getCamera(rt);if(B.isPointLight){let $=U.camera,ot=U.matrix,ut=B.distance||$.far;ut!==$.far&&($.far=ut,$.updateProjectionMatrix()),Cc.setFromMatrixPosition(B.matrixWorld),$.position.copy(Cc),Jp.copy($.position),Jp.add(_I[rt]),$.up.copy(yI[rt]),$.lookAt(Jp),$.updateMatrixWorld(),ot.makeTranslation(-Cc.x,-Cc.y,-Cc.z),Ov.multiplyMatrices($.projectionMatrix,$.matrixWorldInverse),U._frustum.setFromProjectionMatrix(Ov,$.coordinateSystem,$.reversedDepth)}if(U.map.isWebGLCubeRenderTarget)e.setRenderTarget(U.map,rt),e.clear();else{rt===0&&(e.setRenderTarget(U.map),e.clear());let $=U.getViewport(rt);o.set(s.x*$.x,s.y*$.y,s.x*$.z,s.y*$.w),N.viewport(o)}i=U.getFrustum(rt),v(y,M,ct,B,q,this.type)}U.isPointLightShadow!==!0&&this.type===ko&&x(U,M),U.needsUpdate=!1}m=this.type,g.needsUpdate=!1,e.setRenderTarget(R,C,E)};function x(b,y){let M=t.update(_);f.defines.VSM_SAMPLES!==b.blurSamples&&(f.defines.VSM_SAMPLES=b.blurSamples,d.defines.VSM_SAMPLES=b.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),b.mapPass===null?b.mapPass=new Bn(r.x,r.y,{format:ns,type:Si}):(b.mapPass.width!==b.map.width||b.mapPass.height!==b.map.height)&&b.mapPass.setSize(b.map.width,b.map.height),f.uniforms.shadow_pass.value=b.map.depthTexture,f.uniforms.resolution.value.set(b.map.width,b.map.height),f.uniforms.radius.value=b.radius,e.setRenderTarget(b.mapPass),e.clear(),e.renderBufferDirect(y,null,M,f,_,null),d.uniforms.shadow_pass.value=b.mapPass.texture,d.uniforms.resolution.value.set(b.map.width,b.map.height),d.uniforms.radius.value=b.radius,e.setRenderTarget(b.map),e.clear(),e.renderBufferDirect(y,null,M,d,_,null)}function S(b,y,M,R){let C=null,E=M.isPointLight===!0?b.customDistanceMaterial:b.customDepthMaterial;if(E!==void 0)C=E;else if(C=M.isPointLight===!0?c:a,e.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let N=C.uuid,k=y.uuid,P=l[N];P===void 0&&(P={},l[N]=P);let L=P[k];L===void 0&&(L=C.clone(),P[k]=L,y.addEventListener("dispose",w)),C=L}if(C.visible=y.visible,C.wireframe=y.wireframe,R===ko?C.side=y.shadowSide!==null?y.shadowSide:y.side:C.side=y.shadowSide!==null?y.shadowSide:h[y.side],C.alphaMap=y.alphaMap,C.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,C.map=y.map,C.clipShadows=y.clipShadows,C.clippingPlanes=y.clippingPlanes,C.clipIntersection=y.clipIntersection,C.displacementMap=y.displacementMap,C.displacementScale=y.displacementScale,C.displacementBias=y.displacementBias,C.wireframeLinewidth=y.wireframeLinewidth,C.linewidth=y.linewidth,M.isPointLight===!0&&C.isMeshDistanceMaterial===!0){let N=e.properties.get(C);N.light=M}return C}function v(b,y,M,R,C,E){if(b.visible===!1)return;if(b.layers.test(C)&&(b.isMesh||b.isLine||b.isPoints)&&(b.castShadow||b.receiveShadow&&E===ko)&&(!b.frustumCulled||b.intersectsFrustum(i))){b.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,b.matrixWorld);let P=t.update(b),L=b.material;if(Array.isArray(L)){let B=P.groups;for(let U=0,Z=B.length;U<Z;U++){let F=B[U],G=L[F.materialIndex];if(G&&G.visible){let q=S(b,G,R,E);b.onBeforeShadow(e,b,y,M,P,q,F),e.renderBufferDirect(M,null,P,q,b,F),b.onAfterShadow(e,b,y,M,P,q,F)}}}else if(L.visible){let B=S(b,L,R,E);b.onBeforeShadow(e,b,y,M,P,B,null),e.renderBufferDirect(M,null,P,B,b,null),b.onAfterShadow(e,b,y,M,P,B,null)}}let k=b.children;for(let P=0,L=k.length;P<L;P++)v(k[P],y,M,R,C,E)}function w(b){b.target.removeEventListener("dispose",w);for(let M in l){let R=l[M],C=b.target.uuid;C in R&&(R[C].dispose(),delete R[C])}}}function vI(e,t){function n(){let D=!1,et=new we,j=null,_t=new we(0,0,0,0);return{setMask:function(dt){j!==dt&&!D&&(e.colorMask(dt,dt,dt,dt),j=dt)},setLocked:function(dt){D=dt},setClear:function(dt,mt,It,Yt,ht){ht===!0&&(dt*=Yt,mt*=Yt,It*=Yt),et.set(dt,mt,It,Yt),_t.equals(et)===!1&&(e.clearColor(dt,mt,It,Yt),_t.copy(et))},reset:function(){D=!1,j=null,_t.set(-1,0,0,0)}}}function i(){let D=!1,et=!1,j=null,_t=null,dt=null;return{setReversed:function(mt){if(et!==mt){let It=t.get("EXT_clip_control");mt?It.clipControlEXT(It.LOWER_LEFT_EXT,It.ZERO_TO_ONE_EXT):It.clipControlEXT(It.LOWER_LEFT_EXT,It.NEGATIVE_ONE_TO_ONE_EXT),et=mt;let Yt=dt;dt=null,this.setClear(Yt)}},getReversed:function(){return et},setTest:function(mt){mt?at(e.DEPTH_TEST):J(e.DEPTH_TEST)},setMask:function(mt){j!==mt&&!D&&(e.depthMask(mt),j=mt)},setFunc:function(mt){if(et&&(mt=uv[mt]),_t!==mt){switch(mt){case ou:e.depthFunc(e.NEVER);break;case au:e.depthFunc(e.ALWAYS);break;case cu:e.depthFunc(e.LESS);break;case Eo:e.depthFunc(e.LEQUAL);break;case lu:e.depthFunc(e.EQUAL);break;case uu:e.depthFunc(e.GEQUAL);break;case fu:e.depthFunc(e.GREATER);break;case hu:e.depthFunc(e.NOTEQUAL);break;default:e.depthFunc(e.LEQUAL)}_t=mt}},setLocked:function(mt){D=mt},setClear:function(mt){dt!==mt&&(dt=mt,et&&(mt=1-mt),e.clearDepth(mt))},reset:function(){D=!1,j=null,_t=null,dt=null,et=!1}}}function r(){let D=!1,et=null,j=null,_t=null,dt=null,mt=null,It=null,Yt=null,ht=null;return{setTest:function(Nt){D||(Nt?at(e.STENCIL_TEST):J(e.STENCIL_TEST))},setMask:function(Nt){et!==Nt&&!D&&(e.stencilMask(Nt),et=Nt)},setFunc:function(Nt,qt,wt){(j!==Nt||_t!==qt||dt!==wt)&&(e.stencilFunc(Nt,qt,wt),j=Nt,_t=qt,dt=wt)},setOp:function(Nt,qt,wt){(mt!==Nt||It!==qt||Yt!==wt)&&(e.stencilOp(Nt,qt,wt),mt=Nt,It=qt,Yt=wt)},setLocked:function(Nt){D=Nt},setClear:function(Nt){ht!==Nt&&(e.clearStencil(Nt),ht=Nt)},reset:function(){D=!1,et=null,j=null,_t=null,dt=null,mt=null,It=null,Yt=null,ht=null}}}let s=new n,o=new i,a=new r,c={},l=new WeakMap,u={},h={},f={},d=new WeakMap,p=[],_=null,g=!1,m=null,x=null,S=null,v=null,w=null,b=null,y=null,M=new jt(0,0,0),R=0,C=!1,E=null,N=null,k=null,P=null,L=null,B=e.getParameter(e.MAX_COMBINED_TEXTURE_IMAGE_UNITS),U=!1,Z=0,F=e.getParameter(e.VERSION);F.indexOf("WebGL")!==-1?(Z=parseFloat(/^WebGL (\d)/.exec(F)[1]),U=Z>=1):F.indexOf("OpenGL ES")!==-1&&(Z=parseFloat(/^OpenGL ES (\d)/.exec(F)[1]),U=Z>=2);let G=null,q={},rt=e.getParameter(e.SCISSOR_BOX),ct=e.getParameter(e.VIEWPORT),$=new we().fromArray(rt),ot=new we().fromArray(ct);function ut(D,et,j,_t){let dt=new Uint8Array(4),mt=e.createTexture();e.bindTexture(D,mt),e.texParameteri(D,e.TEXTURE_MIN_FILTER,e.NEAREST),e.texParameteri(D,e.TEXTURE_MAG_FILTER,e.NEAREST);for(let It=0;It<j;It++)D===e.TEXTURE_3D||D===e.TEXTURE_2D_ARRAY?e.texImage3D(et,0,e.RGBA,1,1,_t,0,e.RGBA,e.UNSIGNED_BYTE,dt):e.texImage2D(et+It,0,e.RGBA,1,1,0,e.RGBA,e.UNSIGNED_BYTE,dt);return mt}let st={};st[e.TEXTURE_2D]=ut(e.TEXTURE_2D,e.TEXTURE_2D,1),st[e.TEXTURE_CUBE_MAP]=ut(e.TEXTURE_CUBE_MAP,e.TEXTURE_CUBE_MAP_POSITIVE_X,6),st[e.TEXTURE_2D_ARRAY]=ut(e.TEXTURE_2D_ARRAY,e.TEXTURE_2D_ARRAY,1,1),st[e.TEXTURE_3D]=ut(e.TEXTURE_3D,e.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),a.setClear(0),at(e.DEPTH_TEST),o.setFunc(Eo),he(!1),ce(up),at(e.CULL_FACE),Vt(Ps);function at(D){u[D]!==!0&&(e.enable(D),u[D]=!0)}function J(D){u[D]!==!1&&(e.disable(D),u[D]=!1)}function yt(D,et){return f[D]!==et?(e.bindFramebuffer(D,et),f[D]=et,D===e.DRAW_FRAMEBUFFER&&(f[e.FRAMEBUFFER]=et),D===e.FRAMEBUFFER&&(f[e.DRAW_FRAMEBUFFER]=et),!0):!1}function lt(D,et){let j=p,_t=!1;if(D){j=d.get(et),j===void 0&&(j=[],d.set(et,j));let dt=D.textures;if(j.length!==dt.length||j[0]!==e.COLOR_ATTACHMENT0){for(let mt=0,It=dt.length;mt<It;mt++)j[mt]=e.COLOR_ATTACHMENT0+mt;j.length=dt.length,_t=!0}}else j[0]!==e.BACK&&(j[0]=e.BACK,_t=!0);_t&&e.drawBuffers(j)}function K(D){return _!==D?(e.useProgram(D),_=D,!0):!1}let Lt={[Is]:e.FUNC_ADD,[Lx]:e.FUNC_SUBTRACT,[Nx]:e.FUNC_REVERSE_SUBTRACT};Lt[Dx]=e.MIN,Lt[Ux]=e.MAX;let Mt={[Fx]:e.ZERO,[Ox]:e.ONE,[Bx]:e.SRC_COLOR,[pp]:e.SRC_ALPHA,[Wx]:e.SRC_ALPHA_SATURATE,[Vx]:e.DST_COLOR,[zx]:e.DST_ALPHA,[kx]:e.ONE_MINUS_SRC_COLOR,[mp]:e.ONE_MINUS_SRC_ALPHA,[Hx]:e.ONE_MINUS_DST_COLOR,[Gx]:e.ONE_MINUS_DST_ALPHA,[$x]:e.CONSTANT_COLOR,[Xx]:e.ONE_MINUS_CONSTANT_COLOR,[qx]:e.CONSTANT_ALPHA,[Yx]:e.ONE_MINUS_CONSTANT_ALPHA};function Vt(D,et,j,_t,dt,mt,It,Yt,ht,Nt){if(D===Ps){g===!0&&(J(e.BLEND),g=!1);return}if(g===!1&&(at(e.BLEND),g=!0),D!==Ix){if(D!==m||Nt!==C){if((x!==Is||w!==Is)&&(e.blendEquation(e.FUNC_ADD),x=Is,w=Is),Nt)switch(D){case zo:e.blendFuncSeparate(e.ONE,e.ONE_MINUS_SRC_ALPHA,e.ONE,e.ONE_MINUS_SRC_ALPHA);break;case fp:e.blendFunc(e.ONE,e.ONE);break;case hp:e.blendFuncSeparate(e.ZERO,e.ONE_MINUS_SRC_COLOR,e.ZERO,e.ONE);break;case dp:e.blendFuncSeparate(e.DST_COLOR,e.ONE_MINUS_SRC_ALPHA,e.ZERO,e.ONE);break;default:Ot("WebGLState: Invalid blending: ",D);break}else switch(D){case zo:e.blendFuncSeparate(e.SRC_ALPHA,e.ONE_MINUS_SRC_ALPHA,e.ONE,e.ONE_MINUS_SRC_ALPHA);break;case fp:e.blendFuncSeparate(e.SRC_ALPHA,e.ONE,e.ONE,e.ONE);break;case hp:Ot("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case dp:Ot("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Ot("WebGLState: Invalid blending: ",D);break}S=null,v=null,b=null,y=null,M.set(0,0,0),R=0,m=D,C=Nt}return}dt=dt||et,mt=mt||j,It=It||_t,(et!==x||dt!==w)&&(e.blendEquationSeparate(Lt[et],Lt[dt]),x=et,w=dt),(j!==S||_t!==v||mt!==b||It!==y)&&(e.blendFuncSeparate(Mt[j],Mt[_t],Mt[mt],Mt[It]),S=j,v=_t,b=mt,y=It),(Yt.equals(M)===!1||ht!==R)&&(e.blendColor(Yt.r,Yt.g,Yt.b,ht),M.copy(Yt),R=ht),m=D,C=!1}function Xt(D,et){D.side===Ui?J(e.CULL_FACE):at(e.CULL_FACE);let j=D.side===an;et&&(j=!j),he(j),D.blending===zo&&D.transparent===!1?Vt(Ps):Vt(D.blending,D.blendEquation,D.blendSrc,D.blendDst,D.blendEquationAlpha,D.blendSrcAlpha,D.blendDstAlpha,D.blendColor,D.blendAlpha,D.premultipliedAlpha),o.setFunc(D.depthFunc),o.setTest(D.depthTest),o.setMask(D.depthWrite),s.setMask(D.colorWrite);let _t=D.stencilWrite;a.setTest(_t),_t&&(a.setMask(D.stencilWriteMask),a.setFunc(D.stencilFunc,D.stencilRef,D.stencilFuncMask),a.setOp(D.stencilFail,D.stencilZFail,D.stencilZPass)),We(D.polygonOffset,D.polygonOffsetFactor,D.polygonOffsetUnits),D.alphaToCoverage===!0?at(e.SAMPLE_ALPHA_TO_COVERAGE):J(e.SAMPLE_ALPHA_TO_COVERAGE)}function he(D){E!==D&&(D?e.frontFace(e.CW):e.frontFace(e.CCW),E=D)}function ce(D){D!==Cx?(at(e.CULL_FACE),D!==N&&(D===up?e.cullFace(e.BACK):D===Rx?e.cullFace(e.FRONT):e.cullFace(e.FRONT_AND_BACK))):J(e.CULL_FACE),N=D}function un(D){D!==k&&(U&&e.lineWidth(D),k=D)}function We(D,et,j){D?(at(e.POLYGON_OFFSET_FILL),(P!==et||L!==j)&&(P=et,L=j,o.getReversed()&&(et=-et,j=-j),e.polygonOffset(et,j))):J(e.POLYGON_OFFSET_FILL)}function Wn(D){D?at(e.SCISSOR_TEST):J(e.SCISSOR_TEST)}function $n(D){D===void 0&&(D=e.TEXTURE0+B-1),G!==D&&(e.activeTexture(D),G=D)}function Xn(D,et,j){j===void 0&&(G===null?j=e.TEXTURE0+B-1:j=G);let _t=q[j];_t===void 0&&(_t={type:void 0,texture:void 0},q[j]=_t),(_t.type!==D||_t.texture!==et)&&(G!==j&&(e.activeTexture(j),G=j),e.bindTexture(D,et||st[D]),_t.type=D,_t.texture=et)}function z(){let D=q[G];D!==void 0&&D.type!==void 0&&(e.bindTexture(D.type,null),D.type=void 0,D.texture=void 0)}function qn(){try{e.compressedTexImage2D(...arguments)}catch(D){Ot("WebGLState:",D)}}function Me(){try{e.compressedTexImage3D(...arguments)}catch(D){Ot("WebGLState:",D)}}function Se(){try{e.texSubImage2D(...arguments)}catch(D){Ot("WebGLState:",D)}}function St(){try{e.texSubImage3D(...arguments)}catch(D){Ot("WebGLState:",D)}}function Ue(){try{e.compressedTexSubImage2D(...arguments)}catch(D){Ot("WebGLState:",D)}}function Ut(){try{e.compressedTexSubImage3D(...arguments)}catch(D){Ot("WebGLState:",D)}}function zt(){try{e.texStorage2D(...arguments)}catch(D){Ot("WebGLState:",D)}}function I(){try{e.texStorage3D(...arguments)}catch(D){Ot("WebGLState:",D)}}function T(){try{e.texImage2D(...arguments)}catch(D){Ot("WebGLState:",D)}}function W(){try{e.texImage3D(...arguments)}catch(D){Ot("WebGLState:",D)}}function ft(D){return h[D]!==void 0?h[D]:e.getParameter(D)}function nt(D,et){h[D]!==et&&(e.pixelStorei(D,et),h[D]=et)}function pt(D){$.equals(D)===!1&&(e.scissor(D.x,D.y,D.z,D.w),$.copy(D))}function vt(D){ot.equals(D)===!1&&(e.viewport(D.x,D.y,D.z,D.w),ot.copy(D))}function Q(D,et){let j=l.get(et);j===void 0&&(j=new WeakMap,l.set(et,j));let _t=j.get(D);_t===void 0&&(_t=e.getUniformBlockIndex(et,D.name),e.uniformBlockBinding(et,_t,_t),j.set(D,_t))}function tt(D,et,j){let dt=l.get(et).get(D);c[dt]!==j&&(e.bindBufferBase(e.UNIFORM_BUFFER,dt,j),c[dt]=j)}function gt(){e.disable(e.BLEND),e.disable(e.CULL_FACE),e.disable(e.DEPTH_TEST),e.disable(e.POLYGON_OFFSET_FILL),e.disable(e.SCISSOR_TEST),e.disable(e.STENCIL_TEST),e.disable(e.SAMPLE_ALPHA_TO_COVERAGE),e.blendEquation(e.FUNC_ADD),e.blendFunc(e.ONE,e.ZERO),e.blendFuncSeparate(e.ONE,e.ZERO,e.ONE,e.ZERO),e.blendColor(0,0,0,0),e.colorMask(!0,!0,!0,!0),e.clearColor(0,0,0,0),e.depthMask(!0),e.depthFunc(e.LESS),o.setReversed(!1),e.clearDepth(1),e.stencilMask(4294967295),e.stencilFunc(e.ALWAYS,0,4294967295),e.stencilOp(e.KEEP,e.KEEP,e.KEEP),e.clearStencil(0),e.cullFace(e.BACK),e.frontFace(e.CCW),e.polygonOffset(0,0),e.activeTexture(e.TEXTURE0),e.bindFramebuffer(e.FRAMEBUFFER,null),e.bindFramebuffer(e.DRAW_FRAMEBUFFER,null),e.bindFramebuffer(e.READ_FRAMEBUFFER,null),e.useProgram(null),e.lineWidth(1),e.scissor(0,0,e.canvas.width,e.canvas.height),e.viewport(0,0,e.canvas.width,e.canvas.height),e.pixelStorei(e.PACK_ALIGNMENT,4),e.pixelStorei(e.UNPACK_ALIGNMENT,4),e.pixelStorei(e.UNPACK_FLIP_Y_WEBGL,!1),e.pixelStorei(e.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),e.pixelStorei(e.UNPACK_COLORSPACE_CONVERSION_WEBGL,e.BROWSER_DEFAULT_WEBGL),e.pixelStorei(e.PACK_ROW_LENGTH,0),e.pixelStorei(e.PACK_SKIP_PIXELS,0),e.pixelStorei(e.PACK_SKIP_ROWS,0),e.pixelStorei(e.UNPACK_ROW_LENGTH,0),e.pixelStorei(e.UNPACK_IMAGE_HEIGHT,0),e.pixelStorei(e.UNPACK_SKIP_PIXELS,0),e.pixelStorei(e.UNPACK_SKIP_ROWS,0),e.pixelStorei(e.UNPACK_SKIP_IMAGES,0),u={},h={},G=null,q={},f={},c={},d=new WeakMap,p=[],_=null,g=!1,m=null,x=null,S=null,v=null,w=null,b=null,y=null,M=new jt(0,0,0),R=0,C=!1,E=null,N=null,k=null,P=null,L=null,$.set(0,0,e.canvas.width,e.canvas.height),ot.set(0,0,e.canvas.width,e.canvas.height),s.reset(),o.reset(),a.reset()}return{buffers:{color:s,depth:o,stencil:a},enable:at,disable:J,bindFramebuffer:yt,drawBuffers:lt,useProgram:K,setBlending:Vt,setMaterial:Xt,setFlipSided:he,setCullFace:ce,setLineWidth:un,setPolygonOffset:We,setScissorTest:Wn,activeTexture:$n,bindTexture:Xn,unbindTexture:z,compressedTexImage2D:qn,compressedTexImage3D:Me,texImage2D:T,texImage3D:W,pixelStorei:nt,getParameter:ft,updateUBOMapping:Q,uniformBlockBinding:tt,texStorage2D:zt,texStorage3D:I,texSubImage2D:Se,texSubImage3D:St,compressedTexSubImage2D:Ue,compressedTexSubImage3D:Ut,scissor:pt,viewport:vt,reset:gt}}function bI(e,t,n,i,r,s,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new Ft,u=new WeakMap,h=new Set,f,d=new WeakMap,p=new Set,_=new FinalizationRegistry(I=>p.delete(I)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(I,T){return g?new OffscreenCanvas(I,T):tc("canvas")}function x(I,T,W){let ft=1,nt=zt(I);if((nt.width>W||nt.height>W)&&(ft=W/Math.max(nt.width,nt.height)),ft<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let pt=Math.floor(ft*nt.width),vt=Math.floor(ft*nt.height);f===void 0&&(f=m(pt,vt));let Q=T?m(pt,vt):f;return Q.width=pt,Q.height=vt,Q.getContext("2d").drawImage(I,0,0,pt,vt),Dt("WebGLRenderer: Texture has been resized from ("+nt.width+"x"+nt.height+") to ("+pt+"x"+vt+")."),Q}else return"data"in I&&Dt("WebGLRenderer: Image in DataTexture is too big ("+nt.width+"x"+nt.height+")."),I;return I}function S(I){return I.generateMipmaps}function v(I){e.generateMipmap(I)}function w(I){return I.isWebGLCubeRenderTarget?e.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?e.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?e.TEXTURE_2D_ARRAY:e.TEXTURE_2D}function b(I,T,W,ft,nt,pt=!1){if(I!==null){if(e[I]!==void 0)return e[I];Dt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let vt;ft&&(vt=t.get("EXT_texture_norm16"),vt||Dt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Q=T;if(T===e.RED&&(W===e.FLOAT&&(Q=e.R32F),W===e.HALF_FLOAT&&(Q=e.R16F),W===e.UNSIGNED_BYTE&&(Q=e.R8),W===e.UNSIGNED_SHORT&&vt&&(Q=vt.R16_EXT),W===e.SHORT&&vt&&(Q=vt.R16_SNORM_EXT)),T===e.RED_INTEGER&&(W===e.UNSIGNED_BYTE&&(Q=e.R8UI),W===e.UNSIGNED_SHORT&&(Q=e.R16UI),W===e.UNSIGNED_INT&&(Q=e.R32UI),W===e.BYTE&&(Q=e.R8I),W===e.SHORT&&(Q=e.R16I),W===e.INT&&(Q=e.R32I)),T===e.RG&&(W===e.FLOAT&&(Q=e.RG32F),W===e.HALF_FLOAT&&(Q=e.RG16F),W===e.UNSIGNED_BYTE&&(Q=e.RG8),W===e.UNSIGNED_SHORT&&vt&&(Q=vt.RG16_EXT),W===e.SHORT&&vt&&(Q=vt.RG16_SNORM_EXT)),T===e.RG_INTEGER&&(W===e.UNSIGNED_BYTE&&(Q=e.RG8UI),W===e.UNSIGNED_SHORT&&(Q=e.RG16UI),W===e.UNSIGNED_INT&&(Q=e.RG32UI),W===e.BYTE&&(Q=e.RG8I),W===e.SHORT&&(Q=e.RG16I),W===e.INT&&(Q=e.RG32I)),T===e.RGB_INTEGER&&(W===e.UNSIGNED_BYTE&&(Q=e.RGB8UI),W===e.UNSIGNED_SHORT&&(Q=e.RGB16UI),W===e.UNSIGNED_INT&&(Q=e.RGB32UI),W===e.BYTE&&(Q=e.RGB8I),W===e.SHORT&&(Q=e.RGB16I),W===e.INT&&(Q=e.RGB32I)),T===e.RGBA_INTEGER&&(W===e.UNSIGNED_BYTE&&(Q=e.RGBA8UI),W===e.UNSIGNED_SHORT&&(Q=e.RGBA16UI),W===e.UNSIGNED_INT&&(Q=e.RGBA32UI),W===e.BYTE&&(Q=e.RGBA8I),W===e.SHORT&&(Q=e.RGBA16I),W===e.INT&&(Q=e.RGBA32I)),T===e.RGB&&(W===e.UNSIGNED_SHORT&&vt&&(Q=vt.RGB16_EXT),W===e.SHORT&&vt&&(Q=vt.RGB16_SNORM_EXT),W===e.UNSIGNED_INT_5_9_9_9_REV&&(Q=e.RGB9_E5),W===e.UNSIGNED_INT_10F_11F_11F_REV&&(Q=e.R11F_G11F_B10F)),T===e.RGBA){let tt=pt?Qa:ne.getTransfer(nt);W===e.FLOAT&&(Q=e.RGBA32F),W===e.HALF_FLOAT&&(Q=e.RGBA16F),W===e.UNSIGNED_BYTE&&(Q=tt===le?e.SRGB8_ALPHA8:e.RGBA8),W===e.UNSIGNED_SHORT&&vt&&(Q=vt.RGBA16_EXT),W===e.SHORT&&vt&&(Q=vt.RGBA16_SNORM_EXT),W===e.UNSIGNED_SHORT_4_4_4_4&&(Q=e.RGBA4),W===e.UNSIGNED_SHORT_5_5_5_1&&(Q=e.RGB5_A1)}return(Q===e.R16F||Q===e.R32F||Q===e.RG16F||Q===e.RG32F||Q===e.RGBA16F||Q===e.RGBA32F)&&t.get("EXT_color_buffer_float"),Q}function y(I,T){let W;return I?T===null||T===bi||T===Ns?W=e.DEPTH24_STENCIL8:T===Mi?W=e.DEPTH32F_STENCIL8:T===Vo&&(W=e.DEPTH24_STENCIL8,Dt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):T===null||T===bi||T===Ns?W=e.DEPTH_COMPONENT24:T===Mi?W=e.DEPTH_COMPONENT32F:T===Vo&&(W=e.DEPTH_COMPONENT16),W}function M(I,T){return S(I)===!0||I.isFramebufferTexture&&I.minFilter!==Ye&&I.minFilter!==sn?Math.log2(Math.max(T.width,T.height))+1:I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?T.mipmaps.length:1}function R(I){let T=new WeakRef(I);i.get(I).__ref=T,p.add(T),_.register(I,T,T)}function C(I){let T=i.get(I).__ref;T!==void 0&&(p.delete(T),_.unregister(T))}function E(I){k(I.target)}function N(I){P(I.target)}function k(I){I.removeEventListener("dispose",E),C(I),B(I),I.isVideoTexture&&u.delete(I),I.isHTMLTexture&&h.delete(I)}function P(I){I.removeEventListener("dispose",N),C(I),Z(I)}function L(){for(let I of p){let T=I.deref();T!==void 0&&(T.isRenderTarget===!0?P(T):k(T))}p.clear(),h.clear()}function B(I){let T=i.get(I);if(T.__webglInit===void 0)return;let W=I.source,ft=d.get(W);if(ft){let nt=ft[T.__cacheKey];nt.usedTimes--,nt.usedTimes===0&&U(I),Object.keys(ft).length===0&&d.delete(W)}i.remove(I)}function U(I){let T=i.get(I);e.deleteTexture(T.__webglTexture);let W=I.source,ft=d.get(W);delete ft[T.__cacheKey],o.memory.textures--}function Z(I){let T=i.get(I);T.__depthDisposeCallback&&T.__depthDisposeCallback();let W=I.depthTexture;if(W&&W.renderTarget===I&&k(W),I.isWebGLCubeRenderTarget)for(let nt=0;nt<6;nt++){if(Array.isArray(T.__webglFramebuffer[nt]))for(let pt=0;pt<T.__webglFramebuffer[nt].length;pt++)e.deleteFramebuffer(T.__webglFramebuffer[nt][pt]);else e.deleteFramebuffer(T.__webglFramebuffer[nt]);T.__webglDepthbuffer&&e.deleteRenderbuffer(T.__webglDepthbuffer[nt])}else{if(Array.isArray(T.__webglFramebuffer))for(let nt=0;nt<T.__webglFramebuffer.length;nt++)e.deleteFramebuffer(T.__webglFramebuffer[nt]);else e.deleteFramebuffer(T.__webglFramebuffer);if(T.__webglDepthbuffer&&e.deleteRenderbuffer(T.__webglDepthbuffer),T.__webglMultisampledFramebuffer&&e.deleteFramebuffer(T.__webglMultisampledFramebuffer),T.__webglColorRenderbuffer)for(let nt=0;nt<T.__webglColorRenderbuffer.length;nt++)T.__webglColorRenderbuffer[nt]&&e.deleteRenderbuffer(T.__webglColorRenderbuffer[nt]);T.__webglDepthRenderbuffer&&e.deleteRenderbuffer(T.__webglDepthRenderbuffer)}let ft=I.textures;for(let nt=0,pt=ft.length;nt<pt;nt++){let vt=i.get(ft[nt]);vt.__webglTexture&&(e.deleteTexture(vt.__webglTexture),o.memory.textures--),i.remove(ft[nt])}i.remove(I)}let F=0;function G(){F=0}function q(){return F}function rt(I){F=I}function ct(){let I=F;return I>=r.maxTextures&&Dt("WebGLTextures: Trying to use "+(I+1)+" texture units while this GPU supports only "+r.maxTextures),F+=1,I}function $(I){let T=[];return T.push(I.wrapS),T.push(I.wrapT),T.push(I.wrapR||0),T.push(I.magFilter),T.push(I.minFilter),T.push(I.anisotropy),T.push(I.internalFormat),T.push(I.format),T.push(I.type),T.push(I.generateMipmaps),T.push(I.mipmapsAutoUpdate),T.push(I.premultiplyAlpha),T.push(I.flipY),T.push(I.unpackAlignment),T.push(I.colorSpace),T.join()}function ot(I,T){let W=i.get(I);if(I.isVideoTexture&&Ue(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&W.__version!==I.version){let ft=I.image;if(ft===null)Dt("WebGLRenderer: Texture marked for update but no image data found.");else if(ft.complete===!1)Dt("WebGLRenderer: Texture marked for update but image is incomplete");else{Xt(W,I,T);return}}else I.isExternalTexture&&(W.__webglTexture=I.sourceTexture?I.sourceTexture:null);n.bindTexture(e.TEXTURE_2D,W.__webglTexture,e.TEXTURE0+T)}function ut(I,T){let W=i.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&W.__version!==I.version){Xt(W,I,T);return}else I.isExternalTexture&&(W.__webglTexture=I.sourceTexture?I.sourceTexture:null);n.bindTexture(e.TEXTURE_2D_ARRAY,W.__webglTexture,e.TEXTURE0+T)}function st(I,T){let W=i.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&W.__version!==I.version){Xt(W,I,T);return}n.bindTexture(e.TEXTURE_3D,W.__webglTexture,e.TEXTURE0+T)}function at(I,T){let W=i.get(I);if(I.version>0&&W.__version!==I.version){he(W,I,T);return}n.bindTexture(e.TEXTURE_CUBE_MAP,W.__webglTexture,e.TEXTURE0+T)}let J={[du]:e.REPEAT,[Li]:e.CLAMP_TO_EDGE,[pu]:e.MIRRORED_REPEAT},yt={[Ye]:e.NEAREST,[Kx]:e.NEAREST_MIPMAP_NEAREST,[bc]:e.NEAREST_MIPMAP_LINEAR,[sn]:e.LINEAR,[Vu]:e.LINEAR_MIPMAP_NEAREST,[yr]:e.LINEAR_MIPMAP_LINEAR},lt={[ev]:e.NEVER,[Np]:e.ALWAYS,[nv]:e.LESS,[Ip]:e.LEQUAL,[iv]:e.EQUAL,[Lp]:e.GEQUAL,[rv]:e.GREATER,[sv]:e.NOTEQUAL};function K(I,T){if(T.type===Mi&&t.has("OES_texture_float_linear")===!1&&(T.magFilter===sn||T.magFilter===Vu||T.magFilter===bc||T.magFilter===yr||T.minFilter===sn||T.minFilter===Vu||T.minFilter===bc||T.minFilter===yr)&&Dt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),e.texParameteri(I,e.TEXTURE_WRAP_S,J[T.wrapS]),e.texParameteri(I,e.TEXTURE_WRAP_T,J[T.wrapT]),(I===e.TEXTURE_3D||I===e.TEXTURE_2D_ARRAY)&&e.texParameteri(I,e.TEXTURE_WRAP_R,J[T.wrapR]),e.texParameteri(I,e.TEXTURE_MAG_FILTER,yt[T.magFilter]),e.texParameteri(I,e.TEXTURE_MIN_FILTER,yt[T.minFilter]),T.compareFunction&&(e.texParameteri(I,e.TEXTURE_COMPARE_MODE,e.COMPARE_REF_TO_TEXTURE),e.texParameteri(I,e.TEXTURE_COMPARE_FUNC,lt[T.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(T.magFilter===Ye||T.minFilter!==bc&&T.minFilter!==yr||T.type===Mi&&t.has("OES_texture_float_linear")===!1)return;if(T.anisotropy>1||i.get(T).__currentAnisotropy){let W=t.get("EXT_texture_filter_anisotropic");e.texParameterf(I,W.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(T.anisotropy,r.getMaxAnisotropy())),i.get(T).__currentAnisotropy=T.anisotropy}}}function Lt(I,T){let W=!1;I.__webglInit===void 0&&(I.__webglInit=!0,T.addEventListener("dispose",E),R(T));let ft=T.source,nt=d.get(ft);nt===void 0&&(nt={},d.set(ft,nt));let pt=$(T);if(pt!==I.__cacheKey){nt[pt]===void 0&&(nt[pt]={texture:e.createTexture(),usedTimes:0},o.memory.textures++,W=!0),nt[pt].usedTimes++;let vt=nt[I.__cacheKey];vt!==void 0&&(nt[I.__cacheKey].usedTimes--,vt.usedTimes===0&&U(T)),I.__cacheKey=pt,I.__webglTexture=nt[pt].texture}return W}function Mt(I,T,W){return Math.floor(Math.floor(I/W)/T)}function Vt(I,T,W,ft){let pt=I.updateRanges;if(pt.length===0)n.texSubImage2D(e.TEXTURE_2D,0,0,0,T.width,T.height,W,ft,T.data);else{pt.sort((D,et)=>D.start-et.start);let vt=0;for(let D=1;D<pt.length;D++){let et=pt[vt],j=pt[D],_t=et.start+et.count,dt=Mt(j.start,T.width,4),mt=Mt(et.start,T.width,4);j.start<=_t+1&&dt===mt&&Mt(j.start+j.count-1,T.width,4)===dt?et.count=Math.max(et.count,j.start+j.count-et.start):(++vt,pt[vt]=j)}pt.length=vt+1;let Q=n.getParameter(e.UNPACK_ROW_LENGTH),tt=n.getParameter(e.UNPACK_SKIP_PIXELS),gt=n.getParameter(e.UNPACK_SKIP_ROWS);n.pixelStorei(e.UNPACK_ROW_LENGTH,T.width);for(let D=0,et=pt.length;D<et;D++){let j=pt[D],_t=Math.floor(j.start/4),dt=Math.ceil(j.count/4),mt=_t%T.width,It=Math.floor(_t/T.width),Yt=dt,ht=1;n.pixelStorei(e.UNPACK_SKIP_PIXELS,mt),n.pixelStorei(e.UNPACK_SKIP_ROWS,It),n.texSubImage2D(e.TEXTURE_2D,0,mt,It,Yt,ht,W,ft,T.data)}I.clearUpdateRanges(),n.pixelStorei(e.UNPACK_ROW_LENGTH,Q),n.pixelStorei(e.UNPACK_SKIP_PIXELS,tt),n.pixelStorei(e.UNPACK_SKIP_ROWS,gt)}}function Xt(I,T,W){let ft=e.TEXTURE_2D;(T.isDataArrayTexture||T.isCompressedArrayTexture)&&(ft=e.TEXTURE_2D_ARRAY),T.isData3DTexture&&(ft=e.TEXTURE_3D);let nt=Lt(I,T),pt=T.source;n.bindTexture(ft,I.__webglTexture,e.TEXTURE0+W);let vt=i.get(pt);if(pt.version!==vt.__version||nt===!0){if(n.activeTexture(e.TEXTURE0+W),(typeof ImageBitmap<"u"&&T.image instanceof ImageBitmap)===!1){let ht=ne.getPrimaries(ne.workingColorSpace),Nt=T.colorSpace===vr?null:ne.getPrimaries(T.colorSpace),qt=T.colorSpace===vr||ht===Nt?e.NONE:e.BROWSER_DEFAULT_WEBGL;n.pixelStorei(e.UNPACK_FLIP_Y_WEBGL,T.flipY),n.pixelStorei(e.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),n.pixelStorei(e.UNPACK_COLORSPACE_CONVERSION_WEBGL,qt)}n.pixelStorei(e.UNPACK_ALIGNMENT,T.unpackAlignment);let tt=x(T.image,!1,r.maxTextureSize);tt=Ut(T,tt);let gt=s.convert(T.format,T.colorSpace),D=s.convert(T.type),et=b(T.internalFormat,gt,D,T.normalized,T.colorSpace,T.isVideoTexture);K(ft,T);let j,_t=T.mipmaps,dt=T.isVideoTexture!==!0,mt=vt.__version===void 0||nt===!0,It=pt.dataReady,Yt=M(T,tt);if(T.isDepthTexture)et=y(T.format===xr,T.type),mt&&(dt?n.texStorage2D(e.TEXTURE_2D,1,et,tt.width,tt.height):n.texImage2D(e.TEXTURE_2D,0,et,tt.width,tt.height,0,gt,D,null));else if(T.isDataTexture)if(_t.length>0){dt&&mt&&n.texStorage2D(e.TEXTURE_2D,Yt,et,_t[0].width,_t[0].height);for(let ht=0,Nt=_t.length;ht<Nt;ht++)j=_t[ht],dt?It&&n.texSubImage2D(e.TEXTURE_2D,ht,0,0,j.width,j.height,gt,D,j.data):n.texImage2D(e.TEXTURE_2D,ht,et,j.width,j.height,0,gt,D,j.data);T.generateMipmaps=!1}else dt?(mt&&n.texStorage2D(e.TEXTURE_2D,Yt,et,tt.width,tt.height),It&&Vt(T,tt,gt,D)):n.texImage2D(e.TEXTURE_2D,0,et,tt.width,tt.height,0,gt,D,tt.data);else if(T.isCompressedTexture)if(T.isCompressedArrayTexture){dt&&mt&&n.texStorage3D(e.TEXTURE_2D_ARRAY,Yt,et,_t[0].width,_t[0].height,tt.depth);for(let ht=0,Nt=_t.length;ht<Nt;ht++)if(j=_t[ht],T.format!==wi)if(gt!==null)if(dt){if(It)if(T.layerUpdates.size>0){let qt=Hp(j.width,j.height,T.format,T.type);for(let wt of T.layerUpdates){let fe=j.data.subarray(wt*qt/j.data.BYTES_PER_ELEMENT,(wt+1)*qt/j.data.BYTES_PER_ELEMENT);n.compressedTexSubImage3D(e.TEXTURE_2D_ARRAY,ht,0,0,wt,j.width,j.height,1,gt,fe)}}else n.compressedTexSubImage3D(e.TEXTURE_2D_ARRAY,ht,0,0,0,j.width,j.height,tt.depth,gt,j.data)}else n.compressedTexImage3D(e.TEXTURE_2D_ARRAY,ht,et,j.width,j.height,tt.depth,0,j.data,0,0);else Dt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else dt?It&&n.texSubImage3D(e.TEXTURE_2D_ARRAY,ht,0,0,0,j.width,j.height,tt.depth,gt,D,j.data):n.texImage3D(e.TEXTURE_2D_ARRAY,ht,et,j.width,j.height,tt.depth,0,gt,D,j.data);T.layerUpdates.size>0&&T.clearLayerUpdates()}else{dt&&mt&&n.texStorage2D(e.TEXTURE_2D,Yt,et,_t[0].width,_t[0].height);for(let ht=0,Nt=_t.length;ht<Nt;ht++)j=_t[ht],T.format!==wi?gt!==null?dt?It&&n.compressedTexSubImage2D(e.TEXTURE_2D,ht,0,0,j.width,j.height,gt,j.data):n.compressedTexImage2D(e.TEXTURE_2D,ht,et,j.width,j.height,0,j.data):Dt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):dt?It&&n.texSubImage2D(e.TEXTURE_2D,ht,0,0,j.width,j.height,gt,D,j.data):n.texImage2D(e.TEXTURE_2D,ht,et,j.width,j.height,0,gt,D,j.data)}else if(T.isDataArrayTexture)if(dt){if(mt&&n.texStorage3D(e.TEXTURE_2D_ARRAY,Yt,et,tt.width,tt.height,tt.depth),It)if(T.layerUpdates.size>0){let ht=Hp(tt.width,tt.height,T.format,T.type);for(let Nt of T.layerUpdates){let qt=tt.data.subarray(Nt*ht/tt.data.BYTES_PER_ELEMENT,(Nt+1)*ht/tt.data.BYTES_PER_ELEMENT);n.texSubImage3D(e.TEXTURE_2D_ARRAY,0,0,0,Nt,tt.width,tt.height,1,gt,D,qt)}T.clearLayerUpdates()}else n.texSubImage3D(e.TEXTURE_2D_ARRAY,0,0,0,0,tt.width,tt.height,tt.depth,gt,D,tt.data)}else n.texImage3D(e.TEXTURE_2D_ARRAY,0,et,tt.width,tt.height,tt.depth,0,gt,D,tt.data);else if(T.isData3DTexture)dt?(mt&&n.texStorage3D(e.TEXTURE_3D,Yt,et,tt.width,tt.height,tt.depth),It&&n.texSubImage3D(e.TEXTURE_3D,0,0,0,0,tt.width,tt.height,tt.depth,gt,D,tt.data)):n.texImage3D(e.TEXTURE_3D,0,et,tt.width,tt.height,tt.depth,0,gt,D,tt.data);else if(T.isFramebufferTexture){if(mt)if(dt)n.texStorage2D(e.TEXTURE_2D,Yt,et,tt.width,tt.height);else{let ht=tt.width,Nt=tt.height;for(let qt=0;qt<Yt;qt++)n.texImage2D(e.TEXTURE_2D,qt,et,ht,Nt,0,gt,D,null),ht>>=1,Nt>>=1}}else if(T.isHTMLTexture){if("texElementImage2D"in e){let ht=e.canvas;if(ht.hasAttribute("layoutsubtree")||ht.setAttribute("layoutsubtree","true"),tt.parentNode!==ht){ht.appendChild(tt),h.add(T),ht.onpaint=Nt=>{let qt=Nt.changedElements;for(let wt of h)qt.includes(wt.image)&&(wt.needsUpdate=!0)},ht.requestPaint();return}if(e.texElementImage2D.length===3)e.texElementImage2D(e.TEXTURE_2D,e.RGBA8,tt);else{let qt=e.RGBA,wt=e.RGBA,fe=e.UNSIGNED_BYTE;e.texElementImage2D(e.TEXTURE_2D,0,qt,wt,fe,tt)}e.texParameteri(e.TEXTURE_2D,e.TEXTURE_MIN_FILTER,e.LINEAR),e.texParameteri(e.TEXTURE_2D,e.TEXTURE_WRAP_S,e.CLAMP_TO_EDGE),e.texParameteri(e.TEXTURE_2D,e.TEXTURE_WRAP_T,e.CLAMP_TO_EDGE)}}else if(_t.length>0){if(dt&&mt){let ht=zt(_t[0]);n.texStorage2D(e.TEXTURE_2D,Yt,et,ht.width,ht.height)}for(let ht=0,Nt=_t.length;ht<Nt;ht++)j=_t[ht],dt?It&&n.texSubImage2D(e.TEXTURE_2D,ht,0,0,gt,D,j):n.texImage2D(e.TEXTURE_2D,ht,et,gt,D,j);T.generateMipmaps=!1}else if(dt){if(mt){let ht=zt(tt);n.texStorage2D(e.TEXTURE_2D,Yt,et,ht.width,ht.height)}It&&n.texSubImage2D(e.TEXTURE_2D,0,0,0,gt,D,tt)}else n.texImage2D(e.TEXTURE_2D,0,et,gt,D,tt);S(T)&&T.mipmapsAutoUpdate===!0&&v(ft),vt.__version=pt.version,T.onUpdate&&T.onUpdate(T)}I.__version=T.version}function he(I,T,W){if(T.image.length!==6)return;let ft=Lt(I,T),nt=T.source;n.bindTexture(e.TEXTURE_CUBE_MAP,I.__webglTexture,e.TEXTURE0+W);let pt=i.get(nt);if(nt.version!==pt.__version||ft===!0){n.activeTexture(e.TEXTURE0+W);let vt=ne.getPrimaries(ne.workingColorSpace),Q=T.colorSpace===vr?null:ne.getPrimaries(T.colorSpace),tt=T.colorSpace===vr||vt===Q?e.NONE:e.BROWSER_DEFAULT_WEBGL;n.pixelStorei(e.UNPACK_FLIP_Y_WEBGL,T.flipY),n.pixelStorei(e.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),n.pixelStorei(e.UNPACK_ALIGNMENT,T.unpackAlignment),n.pixelStorei(e.UNPACK_COLORSPACE_CONVERSION_WEBGL,tt);let gt=T.isCompressedTexture||T.image[0].isCompressedTexture,D=T.image[0]&&T.image[0].isDataTexture,et=[];for(let wt=0;wt<6;wt++)!gt&&!D?et[wt]=x(T.image[wt],!0,r.maxCubemapSize):et[wt]=D?T.image[wt].image:T.image[wt],et[wt]=Ut(T,et[wt]);let j=et[0],_t=s.convert(T.format,T.colorSpace),dt=s.convert(T.type),mt=b(T.internalFormat,_t,dt,T.normalized,T.colorSpace),It=T.isVideoTexture!==!0,Yt=pt.__version===void 0||ft===!0,ht=nt.dataReady,Nt=M(T,j);K(e.TEXTURE_CUBE_MAP,T);let qt;if(T.isDepthTexture){if(mt=y(T.format===xr,T.type),Yt)if(It)n.texStorage2D(e.TEXTURE_CUBE_MAP,1,mt,j.width,j.height);else for(let wt=0;wt<6;wt++)n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+wt,0,mt,j.width,j.height,0,_t,dt,null)}else if(gt){It&&Yt&&n.texStorage2D(e.TEXTURE_CUBE_MAP,Nt,mt,j.width,j.height);for(let wt=0;wt<6;wt++){qt=et[wt].mipmaps;for(let fe=0;fe<qt.length;fe++){let $e=qt[fe];T.format!==wi?_t!==null?It?ht&&n.compressedTexSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+wt,fe,0,0,$e.width,$e.height,_t,$e.data):n.compressedTexImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+wt,fe,mt,$e.width,$e.height,0,$e.data):Dt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):It?ht&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+wt,fe,0,0,$e.width,$e.height,_t,dt,$e.data):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+wt,fe,mt,$e.width,$e.height,0,_t,dt,$e.data)}}}else{if(qt=T.mipmaps,It&&Yt){qt.length>0&&Nt++;let wt=zt(et[0]);n.texStorage2D(e.TEXTURE_CUBE_MAP,Nt,mt,wt.width,wt.height)}for(let wt=0;wt<6;wt++)if(D){It?ht&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+wt,0,0,0,et[wt].width,et[wt].height,_t,dt,et[wt].data):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+wt,0,mt,et[wt].width,et[wt].height,0,_t,dt,et[wt].data);for(let fe=0;fe<qt.length;fe++){let kr=qt[fe].image[wt].image;It?ht&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+wt,fe+1,0,0,kr.width,kr.height,_t,dt,kr.data):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+wt,fe+1,mt,kr.width,kr.height,0,_t,dt,kr.data)}}else{It?ht&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+wt,0,0,0,_t,dt,et[wt]):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+wt,0,mt,_t,dt,et[wt]);for(let fe=0;fe<qt.length;fe++){let $e=qt[fe];It?ht&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+wt,fe+1,0,0,_t,dt,$e.image[wt]):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+wt,fe+1,mt,_t,dt,$e.image[wt])}}}S(T)&&T.mipmapsAutoUpdate===!0&&v(e.TEXTURE_CUBE_MAP),pt.__version=nt.version,T.onUpdate&&T.onUpdate(T)}I.__version=T.version}function ce(I,T,W,ft,nt,pt){let vt=s.convert(W.format,W.colorSpace),Q=s.convert(W.type),tt=b(W.internalFormat,vt,Q,W.normalized,W.colorSpace),gt=i.get(T),D=i.get(W);if(D.__renderTarget=T,!gt.__hasExternalTextures){let et=Math.max(1,T.width>>pt),j=Math.max(1,T.height>>pt);nt===e.TEXTURE_3D||nt===e.TEXTURE_2D_ARRAY?n.texImage3D(nt,pt,tt,et,j,T.depth,0,vt,Q,null):n.texImage2D(nt,pt,tt,et,j,0,vt,Q,null)}n.bindFramebuffer(e.FRAMEBUFFER,I),St(T)?a.framebufferTexture2DMultisampleEXT(e.FRAMEBUFFER,ft,nt,D.__webglTexture,0,Se(T)):(nt===e.TEXTURE_2D||nt>=e.TEXTURE_CUBE_MAP_POSITIVE_X&&nt<=e.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&e.framebufferTexture2D(e.FRAMEBUFFER,ft,nt,D.__webglTexture,pt),n.bindFramebuffer(e.FRAMEBUFFER,null)}function un(I,T,W){if(e.bindRenderbuffer(e.RENDERBUFFER,I),T.depthBuffer){let ft=T.depthTexture,nt=ft&&ft.isDepthTexture?ft.type:null,pt=y(T.stencilBuffer,nt),vt=T.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT;St(T)?a.renderbufferStorageMultisampleEXT(e.RENDERBUFFER,Se(T),pt,T.width,T.height):W?e.renderbufferStorageMultisample(e.RENDERBUFFER,Se(T),pt,T.width,T.height):e.renderbufferStorage(e.RENDERBUFFER,pt,T.width,T.height),e.framebufferRenderbuffer(e.FRAMEBUFFER,vt,e.RENDERBUFFER,I)}else{let ft=T.textures;for(let nt=0;nt<ft.length;nt++){let pt=ft[nt],vt=s.convert(pt.format,pt.colorSpace),Q=s.convert(pt.type),tt=b(pt.internalFormat,vt,Q,pt.normalized,pt.colorSpace);St(T)?a.renderbufferStorageMultisampleEXT(e.RENDERBUFFER,Se(T),tt,T.width,T.height):W?e.renderbufferStorageMultisample(e.RENDERBUFFER,Se(T),tt,T.width,T.height):e.renderbufferStorage(e.RENDERBUFFER,tt,T.width,T.height)}}e.bindRenderbuffer(e.RENDERBUFFER,null)}function We(I,T,W){let ft=T.isWebGLCubeRenderTarget===!0;if(n.bindFramebuffer(e.FRAMEBUFFER,I),!(T.depthTexture&&T.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let nt=i.get(T.depthTexture);nt.__renderTarget=T;let pt=ft?T.depthTexture.image[0]:T.depthTexture.image;(!nt.__webglTexture||pt.width!==T.width||pt.height!==T.height)&&(pt.width=T.width,pt.height=T.height,T.depthTexture.needsUpdate=!0),ft?at(T.depthTexture,0):ot(T.depthTexture,0);let vt=nt.__webglTexture,Q=Se(T),tt=ft?e.TEXTURE_CUBE_MAP_POSITIVE_X+W:e.TEXTURE_2D,gt=T.depthTexture.format===xr?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT;if(T.depthTexture.format===pr)St(T)?a.framebufferTexture2DMultisampleEXT(e.FRAMEBUFFER,gt,tt,vt,0,Q):e.framebufferTexture2D(e.FRAMEBUFFER,gt,tt,vt,0);else if(T.depthTexture.format===xr)St(T)?a.framebufferTexture2DMultisampleEXT(e.FRAMEBUFFER,gt,tt,vt,0,Q):e.framebufferTexture2D(e.FRAMEBUFFER,gt,tt,vt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Wn(I){let T=i.get(I),W=I.isWebGLCubeRenderTarget===!0;if(T.__boundDepthTexture!==I.depthTexture){let ft=I.depthTexture;if(T.__depthDisposeCallback&&T.__depthDisposeCallback(),ft){let nt=()=>{delete T.__boundDepthTexture,delete T.__depthDisposeCallback,ft.removeEventListener("dispose",nt)};ft.addEventListener("dispose",nt),T.__depthDisposeCallback=nt}T.__boundDepthTexture=ft}if(I.depthTexture&&!T.__autoAllocateDepthBuffer)if(W)for(let ft=0;ft<6;ft++)We(T.__webglFramebuffer[ft],I,ft);else I.texture.mipmaps.length>0?We(T.__webglFramebuffer[0],I,0):We(T.__webglFramebuffer,I,0);else if(W){T.__webglDepthbuffer=[];for(let ft=0;ft<6;ft++)if(n.bindFramebuffer(e.FRAMEBUFFER,T.__webglFramebuffer[ft]),T.__webglDepthbuffer[ft]===void 0)T.__webglDepthbuffer[ft]=e.createRenderbuffer(),un(T.__webglDepthbuffer[ft],I,!1);else{let nt=I.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT,pt=T.__webglDepthbuffer[ft];e.bindRenderbuffer(e.RENDERBUFFER,pt),e.framebufferRenderbuffer(e.FRAMEBUFFER,nt,e.RENDERBUFFER,pt)}}else if(I.texture.mipmaps.length>0?n.bindFramebuffer(e.FRAMEBUFFER,T.__webglFramebuffer[0]):n.bindFramebuffer(e.FRAMEBUFFER,T.__webglFramebuffer),T.__webglDepthbuffer===void 0)T.__webglDepthbuffer=e.createRenderbuffer(),un(T.__webglDepthbuffer,I,!1);else{let nt=I.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT,pt=T.__webglDepthbuffer;e.bindRenderbuffer(e.RENDERBUFFER,pt),e.framebufferRenderbuffer(e.FRAMEBUFFER,nt,e.RENDERBUFFER,pt)}n.bindFramebuffer(e.FRAMEBUFFER,null)}function $n(I,T,W){let ft=i.get(I);T!==void 0&&ce(ft.__webglFramebuffer,I,I.texture,e.COLOR_ATTACHMENT0,e.TEXTURE_2D,0),W!==void 0&&Wn(I)}function Xn(I){let T=I.texture,W=i.get(I),ft=i.get(T);I.addEventListener("dispose",N),R(I);let nt=I.textures,pt=I.isWebGLCubeRenderTarget===!0,vt=nt.length>1;if(vt||(ft.__webglTexture===void 0&&(ft.__webglTexture=e.createTexture()),ft.__version=T.version,o.memory.textures++),pt){W.__webglFramebuffer=[];for(let Q=0;Q<6;Q++)if(T.mipmaps.length>0){W.__webglFramebuffer[Q]=[];for(let tt=0;tt<T.mipmaps.length;tt++)W.__webglFramebuffer[Q][tt]=e.createFramebuffer()}else W.__webglFramebuffer[Q]=e.createFramebuffer()}else{if(T.mipmaps.length>0){W.__webglFramebuffer=[];for(let Q=0;Q<T.mipmaps.length;Q++)W.__webglFramebuffer[Q]=e.createFramebuffer()}else W.__webglFramebuffer=e.createFramebuffer();if(vt)for(let Q=0,tt=nt.length;Q<tt;Q++){let gt=i.get(nt[Q]);gt.__webglTexture===void 0&&(gt.__webglTexture=e.createTexture(),o.memory.textures++)}if(I.samples>0&&St(I)===!1){W.__webglMultisampledFramebuffer=e.createFramebuffer(),W.__webglColorRenderbuffer=[],n.bindFramebuffer(e.FRAMEBUFFER,W.__webglMultisampledFramebuffer);for(let Q=0;Q<nt.length;Q++){let tt=nt[Q];W.__webglColorRenderbuffer[Q]=e.createRenderbuffer(),e.bindRenderbuffer(e.RENDERBUFFER,W.__webglColorRenderbuffer[Q]);let gt=s.convert(tt.format,tt.colorSpace),D=s.convert(tt.type),et=b(tt.internalFormat,gt,D,tt.normalized,tt.colorSpace,I.isXRRenderTarget===!0),j=Se(I);e.renderbufferStorageMultisample(e.RENDERBUFFER,j,et,I.width,I.height),e.framebufferRenderbuffer(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+Q,e.RENDERBUFFER,W.__webglColorRenderbuffer[Q])}e.bindRenderbuffer(e.RENDERBUFFER,null),I.depthBuffer&&(W.__webglDepthRenderbuffer=e.createRenderbuffer(),un(W.__webglDepthRenderbuffer,I,!0)),n.bindFramebuffer(e.FRAMEBUFFER,null)}}if(pt){n.bindTexture(e.TEXTURE_CUBE_MAP,ft.__webglTexture),K(e.TEXTURE_CUBE_MAP,T);for(let Q=0;Q<6;Q++)if(T.mipmaps.length>0)for(let tt=0;tt<T.mipmaps.length;tt++)ce(W.__webglFramebuffer[Q][tt],I,T,e.COLOR_ATTACHMENT0,e.TEXTURE_CUBE_MAP_POSITIVE_X+Q,tt);else ce(W.__webglFramebuffer[Q],I,T,e.COLOR_ATTACHMENT0,e.TEXTURE_CUBE_MAP_POSITIVE_X+Q,0);S(T)?v(e.TEXTURE_CUBE_MAP):T.mipmaps.length>0&&e.texParameteri(e.TEXTURE_CUBE_MAP,e.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),n.unbindTexture()}else if(vt){for(let Q=0,tt=nt.length;Q<tt;Q++){let gt=nt[Q],D=i.get(gt),et=e.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(et=I.isWebGL3DRenderTarget?e.TEXTURE_3D:e.TEXTURE_2D_ARRAY),n.bindTexture(et,D.__webglTexture),K(et,gt),ce(W.__webglFramebuffer,I,gt,e.COLOR_ATTACHMENT0+Q,et,0),S(gt)&&v(et)}n.unbindTexture()}else{let Q=e.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(Q=I.isWebGL3DRenderTarget?e.TEXTURE_3D:e.TEXTURE_2D_ARRAY),n.bindTexture(Q,ft.__webglTexture),K(Q,T),T.mipmaps.length>0)for(let tt=0;tt<T.mipmaps.length;tt++)ce(W.__webglFramebuffer[tt],I,T,e.COLOR_ATTACHMENT0,Q,tt);else ce(W.__webglFramebuffer,I,T,e.COLOR_ATTACHMENT0,Q,0);S(T)?v(Q):T.mipmaps.length>0&&e.texParameteri(Q,e.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),n.unbindTexture()}I.depthBuffer&&Wn(I)}function z(I){let T=I.textures;for(let W=0,ft=T.length;W<ft;W++){let nt=T[W];if(S(nt)&&nt.mipmapsAutoUpdate===!0){let pt=w(I),vt=i.get(nt).__webglTexture;n.bindTexture(pt,vt),v(pt),n.unbindTexture()}}}let qn=[];function Me(I){if(I.samples>0){if(St(I)===!1){let T=I.textures,W=I.width,ft=I.height,nt=e.COLOR_BUFFER_BIT,pt=I.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT,vt=i.get(I),Q=T.length>1;if(Q)for(let gt=0;gt<T.length;gt++)n.bindFramebuffer(e.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),e.framebufferRenderbuffer(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+gt,e.RENDERBUFFER,null),n.bindFramebuffer(e.FRAMEBUFFER,vt.__webglFramebuffer),e.framebufferTexture2D(e.DRAW_FRAMEBUFFER,e.COLOR_ATTACHMENT0+gt,e.TEXTURE_2D,null,0);n.bindFramebuffer(e.READ_FRAMEBUFFER,vt.__webglMultisampledFramebuffer),I.texture.mipmaps.length>0?n.bindFramebuffer(e.DRAW_FRAMEBUFFER,vt.__webglFramebuffer[0]):n.bindFramebuffer(e.DRAW_FRAMEBUFFER,vt.__webglFramebuffer);for(let gt=0;gt<T.length;gt++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(nt|=e.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(nt|=e.STENCIL_BUFFER_BIT)),Q){e.framebufferRenderbuffer(e.READ_FRAMEBUFFER,e.COLOR_ATTACHMENT0,e.RENDERBUFFER,vt.__webglColorRenderbuffer[gt]);let D=i.get(T[gt]).__webglTexture;e.framebufferTexture2D(e.DRAW_FRAMEBUFFER,e.COLOR_ATTACHMENT0,e.TEXTURE_2D,D,0)}e.blitFramebuffer(0,0,W,ft,0,0,W,ft,nt,e.NEAREST),c===!0&&(qn.length=0,qn.push(e.COLOR_ATTACHMENT0+gt),I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&qn.push(pt),e.invalidateFramebuffer(e.READ_FRAMEBUFFER,qn))}if(n.bindFramebuffer(e.READ_FRAMEBUFFER,null),n.bindFramebuffer(e.DRAW_FRAMEBUFFER,null),Q)for(let gt=0;gt<T.length;gt++){n.bindFramebuffer(e.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),e.framebufferRenderbuffer(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+gt,e.RENDERBUFFER,vt.__webglColorRenderbuffer[gt]);let D=i.get(T[gt]).__webglTexture;n.bindFramebuffer(e.FRAMEBUFFER,vt.__webglFramebuffer),e.framebufferTexture2D(e.DRAW_FRAMEBUFFER,e.COLOR_ATTACHMENT0+gt,e.TEXTURE_2D,D,0)}n.bindFramebuffer(e.DRAW_FRAMEBUFFER,vt.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&c){let T=I.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT;e.invalidateFramebuffer(e.DRAW_FRAMEBUFFER,[T])}}}function Se(I){return Math.min(r.maxSamples,I.samples)}function St(I){let T=i.get(I);return I.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&T.__useRenderToTexture!==!1}function Ue(I){let T=o.render.frame;u.get(I)!==T&&(u.set(I,T),I.update())}function Ut(I,T){let W=I.colorSpace,ft=I.format,nt=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||W!==ja&&W!==vr&&(ne.getTransfer(W)===le?(ft!==wi||nt!==En)&&Dt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ot("WebGLTextures: Unsupported texture color space:",W)),T}function zt(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(l.width=I.naturalWidth||I.width,l.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(l.width=I.displayWidth,l.height=I.displayHeight):(l.width=I.width,l.height=I.height),l}this.allocateTextureUnit=ct,this.resetTextureUnits=G,this.getTextureUnits=q,this.setTextureUnits=rt,this.setTexture2D=ot,this.setTexture2DArray=ut,this.setTexture3D=st,this.setTextureCube=at,this.rebindTextures=$n,this.setupRenderTarget=Xn,this.updateRenderTargetMipmap=z,this.updateMultisampleRenderTarget=Me,this.setupDepthRenderbuffer=Wn,this.setupFrameBufferTexture=ce,this.useMultisampledRTT=St,this.dispose=L}function MI(e,t){function n(i,r=vr){let s,o=ne.getTransfer(r);if(i===En)return e.UNSIGNED_BYTE;if(i===Wu)return e.UNSIGNED_SHORT_4_4_4_4;if(i===$u)return e.UNSIGNED_SHORT_5_5_5_1;if(i===Ap)return e.UNSIGNED_INT_5_9_9_9_REV;if(i===Ep)return e.UNSIGNED_INT_10F_11F_11F_REV;if(i===wp)return e.BYTE;if(i===Tp)return e.SHORT;if(i===Vo)return e.UNSIGNED_SHORT;if(i===Hu)return e.INT;if(i===bi)return e.UNSIGNED_INT;if(i===Mi)return e.FLOAT;if(i===Si)return e.HALF_FLOAT;if(i===Cp)return e.ALPHA;if(i===Rp)return e.RGB;if(i===wi)return e.RGBA;if(i===pr)return e.DEPTH_COMPONENT;if(i===xr)return e.DEPTH_STENCIL;if(i===Pp)return e.RED;if(i===Xu)return e.RED_INTEGER;if(i===ns)return e.RG;if(i===qu)return e.RG_INTEGER;if(i===Yu)return e.RGBA_INTEGER;if(i===Mc||i===Sc||i===wc||i===Tc)if(o===le)if(s=t.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(i===Mc)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Sc)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===wc)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Tc)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=t.get("WEBGL_compressed_texture_s3tc"),s!==null){if(i===Mc)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Sc)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===wc)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Tc)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Zu||i===Ju||i===Ku||i===ju)if(s=t.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(i===Zu)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Ju)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Ku)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===ju)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Qu||i===tf||i===ef||i===nf||i===rf||i===Ac||i===sf)if(s=t.get("WEBGL_compressed_texture_etc"),s!==null){if(i===Qu||i===tf)return o===le?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(i===ef)return o===le?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(i===nf)return s.COMPRESSED_R11_EAC;if(i===rf)return s.COMPRESSED_SIGNED_R11_EAC;if(i===Ac)return s.COMPRESSED_RG11_EAC;if(i===sf)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===of||i===af||i===cf||i===lf||i===uf||i===ff||i===hf||i===df||i===pf||i===mf||i===gf||i===_f||i===yf||i===xf)if(s=t.get("WEBGL_compressed_texture_astc"),s!==null){if(i===of)return o===le?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===af)return o===le?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===cf)return o===le?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===lf)return o===le?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===uf)return o===le?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===ff)return o===le?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===hf)return o===le?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===df)return o===le?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===pf)return o===le?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===mf)return o===le?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===gf)return o===le?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===_f)return o===le?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===yf)return o===le?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===xf)return o===le?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===vf||i===bf||i===Mf)if(s=t.get("EXT_texture_compression_bptc"),s!==null){if(i===vf)return o===le?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===bf)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Mf)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Sf||i===wf||i===Ec||i===Tf)if(s=t.get("EXT_texture_compression_rgtc"),s!==null){if(i===Sf)return s.COMPRESSED_RED_RGTC1_EXT;if(i===wf)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Ec)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Tf)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Ns?e.UNSIGNED_INT_24_8:e[i]!==void 0?e[i]:null}return{convert:n}}var SI=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,wI=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,im=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,n){if(this.texture===null){let i=new cc(t.texture);(t.depthNear!==n.depthNear||t.depthFar!==n.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let n=t.cameras[0].viewport,i=new Ni({vertexShader:SI,fragmentShader:wI,uniforms:{depthColor:{value:this.texture},depthWidth:{value:n.z},depthHeight:{value:n.w}}});this.mesh=new jn(new lc(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},rm=class extends vi{constructor(t,n){super();let i=this,r=null,s=1,o=null,a="local-floor",c=1,l=null,u=null,h=null,f=null,d=null,p=null,_=typeof XRWebGLBinding<"u",g=new im,m={},x=n.getContextAttributes(),S=null,v=null,w=[],b=[],y=new Ft,M=null,R=null,C=new vn;C.viewport=new we;let E=new vn;E.viewport=new we;let N=[C,E],k=new Ou,P=null,L=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function($){let ot=w[$];return ot===void 0&&(ot=new No,w[$]=ot),ot.getTargetRaySpace()},this.getControllerGrip=function($){let ot=w[$];return ot===void 0&&(ot=new No,w[$]=ot),ot.getGripSpace()},this.getHand=function($){let ot=w[$];return ot===void 0&&(ot=new No,w[$]=ot),ot.getHandSpace()};function B($){let ot=b.indexOf($.inputSource);if(ot===-1)return;let ut=w[ot];ut!==void 0&&(ut.update($.inputSource,$.frame,l||o),ut.dispatchEvent({type:$.type,data:$.inputSource}))}function U(){r.removeEventListener("select",B),r.removeEventListener("selectstart",B),r.removeEventListener("selectend",B),r.removeEventListener("squeeze",B),r.removeEventListener("squeezestart",B),r.removeEventListener("squeezeend",B),r.removeEventListener("end",U),r.removeEventListener("inputsourceschange",Z);for(let $=0;$<w.length;$++){let ot=b[$];ot!==null&&(b[$]=null,w[$].disconnect(ot))}P=null,L=null,g.reset();for(let $ in m)delete m[$];if(t.setRenderTarget(S),d=null,f=null,h=null,r=null,v=null,ct.stop(),i.isPresenting=!1,t.setPixelRatio(M),t.setSize(y.width,y.height,!1),R!==null){let $=R.camera;$.fov=R.fov,$.zoom=R.zoom,$.updateProjectionMatrix(),R=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function($){s=$,i.isPresenting===!0&&Dt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function($){a=$,i.isPresenting===!0&&Dt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function($){l=$},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h===null&&_&&(h=new XRWebGLBinding(r,n)),h},this.getFrame=function(){return p},this.getSession=function(){return r},this.setSession=async function($){if(r=$,r!==null){if(S=t.getRenderTarget(),r.addEventListener("select",B),r.addEventListener("selectstart",B),r.addEventListener("selectend",B),r.addEventListener("squeeze",B),r.addEventListener("squeezestart",B),r.addEventListener("squeezeend",B),r.addEventListener("end",U),r.addEventListener("inputsourceschange",Z),x.xrCompatible!==!0&&await n.makeXRCompatible(),M=t.getPixelRatio(),t.getSize(y),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let ut=null,st=null,at=null;x.depth&&(at=x.stencil?n.DEPTH24_STENCIL8:n.DEPTH_COMPONENT24,ut=x.stencil?xr:pr,st=x.stencil?Ns:bi);let J={colorFormat:n.RGBA8,depthFormat:at,scaleFactor:s};h=this.getBinding(),f=h.createProjectionLayer(J),r.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),v=new Bn(f.textureWidth,f.textureHeight,{format:wi,type:En,depthTexture:new _r(f.textureWidth,f.textureHeight,st,void 0,void 0,void 0,void 0,void 0,void 0,ut),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let ut={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:s};d=new XRWebGLLayer(r,n,ut),r.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),v=new Bn(d.framebufferWidth,d.framebufferHeight,{format:wi,type:En,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await r.requestReferenceSpace(a),ct.setContext(r),ct.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function Z($){for(let ot=0;ot<$.removed.length;ot++){let ut=$.removed[ot],st=b.indexOf(ut);st>=0&&(b[st]=null,w[st].disconnect(ut))}for(let ot=0;ot<$.added.length;ot++){let ut=$.added[ot],st=b.indexOf(ut);if(st===-1){for(let J=0;J<w.length;J++)if(J>=b.length){b.push(ut),st=J;break}else if(b[J]===null){b[J]=ut,st=J;break}if(st===-1)break}let at=w[st];at&&at.connect(ut)}}function F($,ot){ot===null?$.matrixWorld.copy($.matrix):$.matrixWorld.multiplyMatrices(ot.matrixWorld,$.matrix),$.matrixWorldInverse.copy($.matrixWorld).invert()}this.updateCamera=function($){if(r===null)return;let ot=$.near,ut=$.far;g.texture!==null&&(g.depthNear>0&&(ot=g.depthNear),g.depthFar>0&&(ut=g.depthFar)),k.near=E.near=C.near=ot,k.far=E.far=C.far=ut,(P!==k.near||L!==k.far)&&(r.updateRenderState({depthNear:k.near,depthFar:k.far}),P=k.near,L=k.far),k.layers.mask=$.layers.mask|6,C.layers.mask=k.layers.mask&-5,E.layers.mask=k.layers.mask&-3;let st=$.parent,at=k.cameras;F(k,st);for(let J=0;J<at.length;J++)F(at[J],st);k.projectionMatrix.copy(C.projectionMatrix),k.projectionMatrixInverse.copy(C.projectionMatrixInverse),R===null&&$.isPerspectiveCamera&&(R={camera:$,fov:$.fov,zoom:$.zoom}),G($,k,st)};function G($,ot,ut){ut===null?$.matrix.copy(ot.matrixWorld):($.matrix.copy(ut.matrixWorld),$.matrix.invert(),$.matrix.multiply(ot.matrixWorld)),$.matrix.decompose($.position,$.quaternion,$.scale),$.updateMatrixWorld(!0),$.projectionMatrix.copy(ot.projectionMatrix),$.projectionMatrixInverse.copy(ot.projectionMatrixInverse),$.isPerspectiveCamera&&($.fov=Po*2*Math.atan(1/$.projectionMatrix.elements[5]),$.zoom=1)}this.getCamera=function(){return k},this.getFoveation=function(){if(!(f===null&&d===null))return c},this.setFoveation=function($){c=$,f!==null&&(f.fixedFoveation=$),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=$)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(k)},this.getCameraTexture=function($){return m[$]};let q=null;function rt($,ot){if(u=ot.getViewerPose(l||o),p=ot,u!==null){let ut=u.views;d!==null&&(t.setRenderTargetFramebuffer(v,d.framebuffer),t.setRenderTarget(v));let st=!1;ut.length!==k.cameras.length&&(k.cameras.length=0,st=!0);for(let lt=0;lt<ut.length;lt++){let K=ut[lt],Lt=null;if(d!==null)Lt=d.getViewport(K);else{let Vt=h.getViewSubImage(f,K);Lt=Vt.viewport,lt===0&&(t.setRenderTargetTextures(v,Vt.colorTexture,Vt.depthStencilTexture),t.setRenderTarget(v))}let Mt=N[lt];Mt===void 0&&(Mt=new vn,Mt.layers.enable(lt),Mt.viewport=new we,N[lt]=Mt),Mt.matrix.fromArray(K.transform.matrix),Mt.matrix.decompose(Mt.position,Mt.quaternion,Mt.scale),Mt.projectionMatrix.fromArray(K.projectionMatrix),Mt.projectionMatrixInverse.copy(Mt.projectionMatrix).invert(),Mt.viewport.set(Lt.x,Lt.y,Lt.width,Lt.height),lt===0&&(k.matrix.copy(Mt.matrix),k.matrix.decompose(k.position,k.quaternion,k.scale)),st===!0&&k.cameras.push(Mt)}let at=r.enabledFeatures;if(at&&at.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&_){h=i.getBinding();let lt=h.getDepthInformation(ut[0]);lt&&lt.isValid&&lt.texture&&g.init(lt,r.renderState)}if(at&&at.includes("camera-access")&&_){t.state.unbindTexture(),h=i.getBinding();for(let lt=0;lt<ut.length;lt++){let K=ut[lt].camera;if(K){let Lt=m[K];Lt||(Lt=new cc,m[K]=Lt);let Mt=h.getCameraImage(K);Lt.sourceTexture=Mt}}}}for(let ut=0;ut<w.length;ut++){let st=b[ut],at=w[ut];st!==null&&at!==void 0&&at.update(st,ot,l||o)}q&&q($,ot),ot.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ot}),p=null}let ct=new Bv;ct.setAnimationLoop(rt),this.setAnimationLoop=function($){q=$},this.dispose=function(){}}},TI=new de,Yv=new kt;Yv.set(-1,0,0,0,1,0,0,0,1);function AI(e,t){function n(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function i(g,m){m.color.getRGB(g.fogColor.value,zp(e)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function r(g,m,x,S,v){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?s(g,m):m.isMeshLambertMaterial?(s(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(s(g,m),h(g,m)):m.isMeshPhongMaterial?(s(g,m),u(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(s(g,m),f(g,m),m.isMeshPhysicalMaterial&&d(g,m,v)):m.isMeshMatcapMaterial?(s(g,m),p(g,m)):m.isMeshDepthMaterial?s(g,m):m.isMeshDistanceMaterial?(s(g,m),_(g,m)):m.isMeshNormalMaterial?s(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?c(g,m,x,S):m.isSpriteMaterial?l(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function s(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,n(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,n(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,n(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===an&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,n(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===an&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,n(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,n(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,n(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let x=t.get(m),S=x.envMap,v=x.envMapRotation;S&&(g.envMap.value=S,g.envMapRotation.value.setFromMatrix4(TI.makeRotationFromEuler(v)).transpose(),S.isCubeTexture&&S.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Yv),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,n(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,n(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,n(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function c(g,m,x,S){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*x,g.scale.value=S*.5,m.map&&(g.map.value=m.map,n(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,n(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function l(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,n(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,n(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function u(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function h(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function f(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,n(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,n(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function d(g,m,x){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,n(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,n(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,n(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,n(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,n(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,n(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===an&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,n(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,n(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=x.texture,g.transmissionSamplerSize.value.set(x.width,x.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,n(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,n(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,n(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,n(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,n(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function _(g,m){let x=t.get(m).light;g.referencePosition.value.setFromMatrixPosition(x.matrixWorld),g.nearDistance.value=x.shadow.camera.near,g.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:r}}function EI(e,t,n,i){let r={},s={};function o(x,S){let v=S.program;i.uniformBlockBinding(x,v,r[x.id])}function a(x,S){let v=r[x.id];v===void 0&&(p(x),v=c(x),r[x.id]=v,x.addEventListener("dispose",g));let w=S.program;i.updateUBOMapping(x,w);let b=t.render.frame;s[x.id]!==b&&(l(x),s[x.id]=b)}function c(x){let S=e.createBuffer(),v=x.__size,w=x.usage;return e.bindBuffer(e.UNIFORM_BUFFER,S),e.bufferData(e.UNIFORM_BUFFER,v,w),e.bindBuffer(e.UNIFORM_BUFFER,null),S}function l(x){let S=r[x.id],v=x.uniforms,w=x.__cache;e.bindBuffer(e.UNIFORM_BUFFER,S);for(let b=0,y=v.length;b<y;b++){let M=v[b];if(Array.isArray(M))for(let R=0,C=M.length;R<C;R++)u(M[R],b,R,w);else u(M,b,0,w)}e.bindBuffer(e.UNIFORM_BUFFER,null)}function u(x,S,v,w){if(f(x,S,v,w)===!0){let b=x.__offset,y=x.value;if(Array.isArray(y)){let M=0;for(let R=0;R<y.length;R++){let C=y[R],E=_(C,!0);h(C,x.__data,M),M+=E.storage/Float32Array.BYTES_PER_ELEMENT}}else h(y,x.__data,0);e.bufferSubData(e.UNIFORM_BUFFER,b,x.__data)}}function h(x,S,v){typeof x=="number"||typeof x=="boolean"?S[v]=x:x.isMatrix3?(S[v]=x.elements[0],S[v+1]=x.elements[1],S[v+2]=x.elements[2],S[v+3]=0,S[v+4]=x.elements[3],S[v+5]=x.elements[4],S[v+6]=x.elements[5],S[v+7]=0,S[v+8]=x.elements[6],S[v+9]=x.elements[7],S[v+10]=x.elements[8],S[v+11]=0):ArrayBuffer.isView(x)?S.set(x.subarray(0,S.length-v),v):x.toArray(S,v)}function f(x,S,v,w){let b=x.value,y=S+"_"+v;if(Array.isArray(b)){w[y]===void 0&&(w[y]=[]);let M=w[y],R=!1;for(let C=0;C<b.length;C++)d(b[C],M,C)===!0&&(R=!0);return R}return d(b,w,y)}function d(x,S,v){if(S[v]===void 0)return typeof x=="number"||typeof x=="boolean"?S[v]=x:ArrayBuffer.isView(x)?S[v]=x.slice():S[v]=x.clone(),!0;{let w=S[v];if(typeof x=="number"||typeof x=="boolean"){if(w!==x)return S[v]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(w.equals(x)===!1)return w.copy(x),!0}}return!1}function p(x){let S=x.uniforms,v=0,w=16;for(let y=0,M=S.length;y<M;y++){let R=Array.isArray(S[y])?S[y]:[S[y]];for(let C=0,E=R.length;C<E;C++){let N=R[C],k=Array.isArray(N.value)?N.value:[N.value],P=Array.isArray(S[y])||Array.isArray(N.value),L=v;for(let U=0,Z=k.length;U<Z;U++){let F=k[U],G=_(F,P),q=v%w,rt=q%G.boundary,ct=q+rt;v+=rt,ct!==0&&w-ct<G.storage&&(v+=w-ct),U===0&&(L=v),v+=G.storage}let B=N.type==="int"?Int32Array:N.type==="uint"?Uint32Array:Float32Array;N.__data=new B((v-L)/Float32Array.BYTES_PER_ELEMENT),N.__offset=L}}let b=v%w;return b>0&&(v+=w-b),x.__size=v,x.__cache={},this}function _(x,S){let v={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(v.boundary=4,v.storage=4):x.isVector2?(v.boundary=8,v.storage=8):x.isVector3||x.isColor?(v.boundary=16,v.storage=12):x.isVector4?(v.boundary=16,v.storage=16):x.isMatrix3?(v.boundary=16,v.storage=48):x.isMatrix4?(v.boundary=16,v.storage=64):x.isTexture?Dt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(v.boundary=16,v.storage=x.byteLength):Dt("WebGLRenderer: Unsupported uniform value type.",x),S===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function g(x){let S=x.target;S.removeEventListener("dispose",g),e.deleteBuffer(r[S.id]),delete r[S.id],delete s[S.id]}function m(){for(let x in r)e.deleteBuffer(r[x]);r={},s={}}return{bind:o,update:a,dispose:m}}var CI=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Oi=null;function RI(){return Oi===null&&(Oi=new Uo(CI,16,16,ns,Si),Oi.name="DFG_LUT",Oi.minFilter=sn,Oi.magFilter=sn,Oi.wrapS=Li,Oi.wrapT=Li,Oi.generateMipmaps=!1,Oi.needsUpdate=!0),Oi}var Pf=class{constructor(t={}){let{canvas:n=av(),context:i=null,depth:r=!0,stencil:s=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1,outputBufferType:d=En}=t;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let _=d,g=new Set([Yu,qu,Xu]),m=new Set([En,bi,Vo,Ns,Wu,$u]),x=new Uint32Array(4),S=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},w=null,b=null,y=[],M=[],R=null;this.domElement=n,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Fi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let C=this,E=!1,N=null,k=null,P=null,L=null;this._outputColorSpace=yn;let B=0,U=0,Z=null,F=-1,G=null,q=new we,rt=new we,ct=null,$=new jt(0),ot=0,ut=n.width,st=n.height,at=1,J=null,yt=null,lt=new we(0,0,ut,st),K=new we(0,0,ut,st),Lt=!1,Mt=new Zr,Vt=new xu,Xt=!1,he=!1,ce=new de,un=new V,We=new we,Wn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},$n=!1;function Xn(){return Z===null?at:1}let z=i;function qn(A,O){return n.getContext(A,O)}let Me,Se,St,Ue,Ut,zt,I,T,W,ft,nt,pt,vt,Q,tt,gt,D,et,j,_t,dt,mt,It;try{let A={alpha:!0,depth:r,stencil:s,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in n&&n.setAttribute("data-engine",`three.js r${"187"}`),n.addEventListener("webglcontextlost",Nt,!1),n.addEventListener("webglcontextrestored",qt,!1),n.addEventListener("webglcontextcreationerror",wt,!1),z===null){let O="webgl2";if(z=qn(O,A),z===null)throw qn(O)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Yt()}catch(A){throw n.removeEventListener("webglcontextlost",Nt,!1),n.removeEventListener("webglcontextrestored",qt,!1),n.removeEventListener("webglcontextcreationerror",wt,!1),Ot("WebGLRenderer: "+A.message),A}function Yt(){Me=new zR(z),Me.init(),dt=new MI(z,Me),Se=new RR(z,Me,t,dt),St=new vI(z,Me),Se.reversedDepthBuffer&&f&&St.buffers.depth.setReversed(!0),k=z.createFramebuffer(),P=z.createFramebuffer(),L=z.createFramebuffer(),Ue=new HR(z),Ut=new oI,zt=new bI(z,Me,St,Ut,Se,dt,Ue),I=new kR(C),T=new $2(z),mt=new ER(z,T),W=new GR(z,T,Ue,mt),ft=new $R(z,W,T,mt,Ue),et=new WR(z,Se,zt),tt=new PR(Ut),nt=new sI(C,I,Me,Se,mt,tt),pt=new AI(C,Ut),vt=new cI,Q=new pI(Me),D=new AR(C,I,St,ft,p,c),gt=new xI(C,ft,Se),It=new EI(z,Ue,Se,St),j=new CR(z,Me,Ue),_t=new VR(z,Me,Ue),Ue.programs=nt.programs,C.capabilities=Se,C.extensions=Me,C.properties=Ut,C.renderLists=vt,C.shadowMap=gt,C.state=St,C.info=Ue}_!==En&&(R=new qR(_,n.width,n.height,a,r,s));let ht=new rm(C,z);this.xr=ht,this.getContext=function(){return z},this.getContextAttributes=function(){return z.getContextAttributes()},this.forceContextLoss=function(){let A=Me.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=Me.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return at},this.setPixelRatio=function(A){A!==void 0&&(at=A,this.setSize(ut,st,!1))},this.getSize=function(A){return A.set(ut,st)},this.setSize=function(A,O,Y=!0){if(ht.isPresenting){Dt("WebGLRenderer: Can't change size while VR device is presenting.");return}ut=A,st=O,n.width=Math.floor(A*at),n.height=Math.floor(O*at),Y===!0&&(n.style.width=A+"px",n.style.height=O+"px"),R!==null&&R.setSize(n.width,n.height),this.setViewport(0,0,A,O)},this.getDrawingBufferSize=function(A){return A.set(ut*at,st*at).floor()},this.setDrawingBufferSize=function(A,O,Y){ut=A,st=O,at=Y,n.width=Math.floor(A*Y),n.height=Math.floor(O*Y),this.setViewport(0,0,A,O)},this.setEffects=function(A){if(_===En){Ot("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let O=0;O<A.length;O++)if(A[O].isOutputPass===!0){Dt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}R.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(q)},this.getViewport=function(A){return A.copy(lt)},this.setViewport=function(A,O,Y,H){A.isVector4?lt.set(A.x,A.y,A.z,A.w):lt.set(A,O,Y,H),St.viewport(q.copy(lt).multiplyScalar(Xn()).round())},this.getScissor=function(A){return A.copy(K)},this.setScissor=function(A,O,Y,H){A.isVector4?K.set(A.x,A.y,A.z,A.w):K.set(A,O,Y,H),St.scissor(rt.copy(K).multiplyScalar(Xn()).round())},this.getScissorTest=function(){return Lt},this.setScissorTest=function(A){St.setScissorTest(Lt=A)},this.setOpaqueSort=function(A){J=A},this.setTransparentSort=function(A){yt=A},this.getClearColor=function(A){return A.copy(D.getClearColor())},this.setClearColor=function(){D.setClearColor(...arguments)},this.getClearAlpha=function(){return D.getClearAlpha()},this.setClearAlpha=function(){D.setClearAlpha(...arguments)},this.clear=function(A=!0,O=!0,Y=!0){let H=0;if(A){let X=!1;if(Z!==null){let bt=Z.texture.format;X=g.has(bt)}if(X){let bt=Z.texture.type,Et=m.has(bt),xt=D.getClearColor(),At=D.getClearAlpha(),Pt=xt.r,Gt=xt.g,te=xt.b;Et?(x[0]=Pt,x[1]=Gt,x[2]=te,x[3]=At,z.clearBufferuiv(z.COLOR,0,x)):(S[0]=Pt,S[1]=Gt,S[2]=te,S[3]=At,z.clearBufferiv(z.COLOR,0,S))}else H|=z.COLOR_BUFFER_BIT}O&&(H|=z.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Y&&(H|=z.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),H!==0&&z.clear(H)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),N=A},this.dispose=function(){n.removeEventListener("webglcontextlost",Nt,!1),n.removeEventListener("webglcontextrestored",qt,!1),n.removeEventListener("webglcontextcreationerror",wt,!1),D.dispose(),vt.dispose(),Q.dispose(),zt.dispose(),Ut.dispose(),I.dispose(),ft.dispose(),W.dispose(),mt.dispose(),It.dispose(),nt.dispose(),ht.dispose(),ht.removeEventListener("sessionstart",Vy),ht.removeEventListener("sessionend",Hy),Ms.stop()};function Nt(A){A.preventDefault(),Up("WebGLRenderer: Context Lost."),E=!0}function qt(){Up("WebGLRenderer: Context Restored."),E=!1;let A=Ue.autoReset,O=gt.enabled,Y=gt.autoUpdate,H=gt.needsUpdate,X=gt.type;Yt(),Ue.autoReset=A,gt.enabled=O,gt.autoUpdate=Y,gt.needsUpdate=H,gt.type=X}function wt(A){Ot("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function fe(A){let O=A.target;O.removeEventListener("dispose",fe),$e(O)}function $e(A){kr(A),Ut.remove(A)}function kr(A){let O=Ut.get(A).programs;O!==void 0&&(O.forEach(function(Y){nt.releaseProgram(Y)}),A.isShaderMaterial&&nt.releaseShaderCache(A))}this.renderBufferDirect=function(A,O,Y,H,X,bt){O===null&&(O=Wn);let Et=X.isMesh&&X.matrixWorld.determinantAffine()<0,xt=zE(A,O,Y,H,X);St.setMaterial(H,Et);let At=Y.index,Pt=1;if(H.wireframe===!0){if(At=W.getWireframeAttribute(Y),At===void 0)return;Pt=2}let Gt=Y.drawRange,te=Y.attributes.position,Ct=Gt.start*Pt,ee=(Gt.start+Gt.count)*Pt;bt!==null&&(Ct=Math.max(Ct,bt.start*Pt),ee=Math.min(ee,(bt.start+bt.count)*Pt)),At!==null?(Ct=Math.max(Ct,0),ee=Math.min(ee,At.count)):te!=null&&(Ct=Math.max(Ct,0),ee=Math.min(ee,te.count));let Ne=ee-Ct;if(Ne<0||Ne===1/0)return;mt.setup(X,H,xt,Y,At);let _e,me=j;if(At!==null&&(_e=T.get(At),me=_t,me.setIndex(_e)),X.isMesh)H.wireframe===!0?(St.setLineWidth(H.wireframeLinewidth*Xn()),me.setMode(z.LINES)):me.setMode(z.TRIANGLES);else if(X.isLine){let fn=H.linewidth;fn===void 0&&(fn=1),St.setLineWidth(fn*Xn()),X.isLineSegments?me.setMode(z.LINES):X.isLineLoop?me.setMode(z.LINE_LOOP):me.setMode(z.LINE_STRIP)}else X.isPoints?me.setMode(z.POINTS):X.isSprite&&me.setMode(z.TRIANGLES);if(X.isBatchedMesh)if(Me.get("WEBGL_multi_draw"))me.renderMultiDraw(X._multiDrawStarts,X._multiDrawCounts,X._multiDrawCount);else{let fn=X._multiDrawStarts,Rt=X._multiDrawCounts,_n=X._multiDrawCount,se=At?T.get(At).bytesPerElement:1,Ss=Ut.get(H).currentProgram.getUniforms();for(let hn=0;hn<_n;hn++)Ss.setValue(z,"_gl_DrawID",hn),me.render(fn[hn]/se,Rt[hn])}else if(X.isInstancedMesh)me.renderInstances(Ct,Ne,X.count);else if(Y.isInstancedBufferGeometry){let fn=Y._maxInstanceCount!==void 0?Y._maxInstanceCount:1/0,Rt=Math.min(Y.instanceCount,fn);me.renderInstances(Ct,Ne,Rt)}else me.render(Ct,Ne)};function Gy(A,O,Y,H){N!==null&&A.isNodeMaterial&&N.setObject(H,A),Xt===!0&&tt.setState(A,Y,!1),A.transparent===!0&&A.side===Ui&&A.forceSinglePass===!1?(A.side=an,A.needsUpdate=!0,Va(A,O,H),A.side=Di,A.needsUpdate=!0,Va(A,O,H),A.side=Ui):Va(A,O,H)}this.compile=function(A,O,Y=null){Y===null&&(Y=A),N!==null&&N.renderStart(A,O,Y),b=Q.get(Y),b.init(O),M.push(b),Y.traverseVisible(function(X){X.isLight&&X.layers.test(O.layers)&&(b.pushLight(X),X.castShadow&&b.pushShadow(X))}),A!==Y&&A.traverseVisible(function(X){X.isLight&&X.layers.test(O.layers)&&(b.pushLight(X),X.castShadow&&b.pushShadow(X))}),b.setupLights(),N!==null&&N.updateLights(b.state.lightsArray),he=this.localClippingEnabled,Xt=tt.init(this.clippingPlanes,he),Xt===!0&&tt.setGlobalState(this.clippingPlanes,O),N!==null&&gt.render(b.state.shadowsArray,Y,O);let H=new Set;return A.traverse(function(X){if(!(X.isMesh||X.isPoints||X.isLine||X.isSprite))return;let bt=X.material;if(bt)if(Array.isArray(bt))for(let Et=0;Et<bt.length;Et++){let xt=bt[Et];Gy(xt,Y,O,X),H.add(xt)}else Gy(bt,Y,O,X),H.add(bt)}),b=M.pop(),N!==null&&N.renderEnd(),H},this.compileAsync=function(A,O,Y=null){let H=this.compile(A,O,Y);return new Promise(X=>{function bt(){if(H.forEach(function(Et){let At=Ut.get(Et).currentProgram;(At===void 0||At.isReady())&&H.delete(Et)}),H.size===0){X(A);return}setTimeout(bt,10)}Me.get("KHR_parallel_shader_compile")!==null?bt():setTimeout(bt,10)})};let Ld=null;function BE(A){Ld&&Ld(A)}function Vy(){Ms.stop()}function Hy(){Ms.start()}let Ms=new Bv;Ms.setAnimationLoop(BE),typeof self<"u"&&Ms.setContext(self),this.setAnimationLoop=function(A){Ld=A,ht.setAnimationLoop(A),A===null?Ms.stop():Ms.start()},ht.addEventListener("sessionstart",Vy),ht.addEventListener("sessionend",Hy),this.render=function(A,O){if(O!==void 0&&O.isCamera!==!0){Ot("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(E===!0)return;N!==null&&N.renderStart(A,O);let Y=ht.enabled===!0&&ht.isPresenting===!0,H=R!==null&&(Z===null||Y)&&R.begin(C,Z);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),O.parent===null&&O.matrixWorldAutoUpdate===!0&&O.updateMatrixWorld(),ht.enabled===!0&&ht.isPresenting===!0&&(R===null||R.isCompositing()===!1)&&(ht.cameraAutoUpdate===!0&&ht.updateCamera(O),O=ht.getCamera()),A.isScene===!0&&A.onBeforeRender(C,A,O,Z),b=Q.get(A,M.length),b.init(O),b.state.textureUnits=zt.getTextureUnits(),M.push(b),ce.multiplyMatrices(O.projectionMatrix,O.matrixWorldInverse),O.isArrayCamera?Vt.setFromArrayCamera(O):Mt.setFromProjectionMatrix(ce,Zn,O.reversedDepth),he=this.localClippingEnabled,Xt=tt.init(this.clippingPlanes,he),w=vt.get(A,y.length),w.init(),y.push(w),this.info.render.frame++,ht.enabled===!0&&ht.isPresenting===!0){let Et=C.xr.getDepthSensingMesh();Et!==null&&Nd(Et,O,-1/0,C.sortObjects)}Nd(A,O,0,C.sortObjects),w.finish(),N!==null&&N.updateLights(b.state.lightsArray),C.sortObjects===!0&&w.sort(J,yt),$n=ht.enabled===!1||ht.isPresenting===!1||ht.hasDepthSensing()===!1,$n&&D.addToRenderList(w,A),this.info.autoReset===!0&&this.info.reset(),Xt===!0&&tt.beginShadows();let X=b.state.shadowsArray;if(gt.render(X,A,O),Xt===!0&&tt.endShadows(),(H&&R.hasRenderPass())===!1){let Et=w.opaque,xt=w.transmissive;if(b.setupLights(),O.isArrayCamera){let At=O.cameras;if(xt.length>0)for(let Pt=0,Gt=At.length;Pt<Gt;Pt++){let te=At[Pt];$y(Et,xt,A,te)}$n&&D.render(A);for(let Pt=0,Gt=At.length;Pt<Gt;Pt++){let te=At[Pt];Wy(w,A,te,te.viewport)}}else xt.length>0&&$y(Et,xt,A,O),$n&&D.render(A),Wy(w,A,O)}Z!==null&&U===0&&(zt.updateMultisampleRenderTarget(Z),zt.updateRenderTargetMipmap(Z)),H&&R.end(C),A.isScene===!0&&A.onAfterRender(C,A,O),mt.resetDefaultState(),F=-1,G=null,M.pop(),M.length>0?(b=M[M.length-1],zt.setTextureUnits(b.state.textureUnits),Xt===!0&&tt.setGlobalState(C.clippingPlanes,b.state.camera)):b=null,y.pop(),y.length>0?w=y[y.length-1]:w=null,N!==null&&N.renderEnd()};function Nd(A,O,Y,H){if(A.visible===!1)return;if(A.layers.test(O.layers)){if(A.isGroup)Y=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(O);else if(A.isLight)b.pushLight(A),A.castShadow&&b.pushShadow(A);else if(A.isSprite){let Et=O.isArrayCamera?Vt:Mt;if(!A.frustumCulled||A.intersectsFrustum(Et)){H&&We.setFromMatrixPosition(A.matrixWorld).applyMatrix4(ce);let xt=ft.update(A),At=A.material;At.visible&&w.push(A,xt,At,Y,We.z,null,O)}}else if(A.isMesh||A.isLine||A.isPoints){let Et=O.isArrayCamera?Vt:Mt;if(!A.frustumCulled||A.intersectsFrustum(Et)){let xt=ft.update(A),At=A.material;if(H&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),We.copy(A.boundingSphere.center)):(xt.boundingSphere===null&&xt.computeBoundingSphere(),We.copy(xt.boundingSphere.center)),We.applyMatrix4(A.matrixWorld).applyMatrix4(ce)),Array.isArray(At)){let Pt=xt.groups;for(let Gt=0,te=Pt.length;Gt<te;Gt++){let Ct=Pt[Gt],ee=At[Ct.materialIndex];ee&&ee.visible&&w.push(A,xt,ee,Y,We.z,Ct,O)}}else At.visible&&w.push(A,xt,At,Y,We.z,null,O)}}}let bt=A.children;for(let Et=0,xt=bt.length;Et<xt;Et++)Nd(bt[Et],O,Y,H)}function Wy(A,O,Y,H){let{opaque:X,transmissive:bt,transparent:Et}=A;b.setupLightsView(Y),Xt===!0&&tt.setGlobalState(C.clippingPlanes,Y),H&&St.viewport(q.copy(H)),X.length>0&&Dl(X,O,Y),bt.length>0&&Dl(bt,O,Y),Et.length>0&&Dl(Et,O,Y),St.buffers.depth.setTest(!0),St.buffers.depth.setMask(!0),St.buffers.color.setMask(!0),St.setPolygonOffset(!1)}function $y(A,O,Y,H){if((Y.isScene===!0?Y.overrideMaterial:null)!==null)return;if(b.state.transmissionRenderTarget[H.id]===void 0){let Ct=Me.has("EXT_color_buffer_half_float")||Me.has("EXT_color_buffer_float");b.state.transmissionRenderTarget[H.id]=new Bn(1,1,{generateMipmaps:!0,type:Ct?Si:En,minFilter:yr,samples:Math.max(4,Se.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:ne.workingColorSpace})}let bt=b.state.transmissionRenderTarget[H.id],Et=H.viewport||q;bt.setSize(Et.z*C.transmissionResolutionScale,Et.w*C.transmissionResolutionScale);let xt=C.getRenderTarget(),At=C.getActiveCubeFace(),Pt=C.getActiveMipmapLevel();C.setRenderTarget(bt),C.getClearColor($),ot=C.getClearAlpha(),ot<1&&C.setClearColor(16777215,.5),C.clear(),$n&&D.render(Y);let Gt=C.toneMapping;C.toneMapping=Fi;let te=H.viewport;if(H.viewport!==void 0&&(H.viewport=void 0),b.setupLightsView(H),Xt===!0&&tt.setGlobalState(C.clippingPlanes,H),Dl(A,Y,H),zt.updateMultisampleRenderTarget(bt),zt.updateRenderTargetMipmap(bt),Me.has("WEBGL_multisampled_render_to_texture")===!1){let Ct=!1;for(let ee=0,Ne=O.length;ee<Ne;ee++){let _e=O[ee],{object:me,geometry:fn,material:Rt,group:_n}=_e;if(Rt.side===Ui&&me.layers.test(H.layers)){let se=Rt.side;Rt.side=an,Rt.needsUpdate=!0,Xy(me,Y,H,fn,Rt,_n),Rt.side=se,Rt.needsUpdate=!0,Ct=!0}}Ct===!0&&(zt.updateMultisampleRenderTarget(bt),zt.updateRenderTargetMipmap(bt))}C.setRenderTarget(xt,At,Pt),C.setClearColor($,ot),te!==void 0&&(H.viewport=te),C.toneMapping=Gt}function Dl(A,O,Y){let H=O.isScene===!0?O.overrideMaterial:null;for(let X=0,bt=A.length;X<bt;X++){let Et=A[X],{object:xt,geometry:At,group:Pt}=Et,Gt=Et.material;Gt.allowOverride===!0&&H!==null&&(Gt=H),xt.layers.test(Y.layers)&&Xy(xt,O,Y,At,Gt,Pt)}}function Xy(A,O,Y,H,X,bt){N!==null&&X.isNodeMaterial&&N.setObject(A,X),A.onBeforeRender(C,O,Y,H,X,bt),A.modelViewMatrix.multiplyMatrices(Y.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),X.onBeforeRender(C,O,Y,H,A,bt),X.transparent===!0&&X.side===Ui&&X.forceSinglePass===!1?(X.side=an,X.needsUpdate=!0,C.renderBufferDirect(Y,O,H,X,A,bt),X.side=Di,X.needsUpdate=!0,C.renderBufferDirect(Y,O,H,X,A,bt),X.side=Ui):C.renderBufferDirect(Y,O,H,X,A,bt),A.onAfterRender(C,O,Y,H,X,bt)}function qy(A){let O=0;for(let Y of A)Y.texture!==null&&O++;return O}function Va(A,O,Y){O.isScene!==!0&&(O=Wn);let H=Ut.get(A),X=b.state.lights,bt=b.state.shadowsArray,Et=X.state.version,xt=nt.getParameters(A,X.state,bt,O,Y,b.state.lightProbeGridArray),At=nt.getProgramCacheKey(xt),Pt=H.programs;H.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?O.environment:null,H.fog=O.fog;let Gt=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;H.envMap=I.get(A.envMap||H.environment,Gt),H.envMapRotation=H.environment!==null&&A.envMap===null?O.environmentRotation:A.envMapRotation,Pt===void 0&&(A.addEventListener("dispose",fe),Pt=new Map,H.programs=Pt,H.programVariants=new Map);let te=Pt.get(At);if(te!==void 0){if(H.currentProgram===te&&H.lightsStateVersion===Et)return Zy(A,xt),te}else xt.uniforms=nt.getUniforms(A),N!==null&&A.isNodeMaterial&&N.build(A,Y,xt),A.onBeforeCompile(xt,C),te=nt.acquireProgram(xt,At),Pt.set(At,te),H.uniforms=xt.uniforms;let Ct=H.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(Ct.clippingPlanes=tt.uniform),Zy(A,xt),H.needsLights=VE(A),H.lightsStateVersion=Et,H.needsLights&&(Ct.ambientLightColor.value=X.state.ambient,Ct.lightProbe.value=X.state.probe,Ct.sunLights.value=X.state.sun,Ct.sunLightShadows.value=X.state.sunShadow,Ct.directionalLights.value=X.state.directional,Ct.directionalLightShadows.value=X.state.directionalShadow,Ct.spotLights.value=X.state.spot,Ct.spotLightShadows.value=X.state.spotShadow,Ct.rectAreaLights.value=X.state.rectArea,Ct.ltc_1.value=X.state.rectAreaLTC1,Ct.ltc_2.value=X.state.rectAreaLTC2,Ct.pointLights.value=X.state.point,Ct.pointLightShadows.value=X.state.pointShadow,Ct.hemisphereLights.value=X.state.hemi,Ct.sunShadowMatrix.value=X.state.sunShadowMatrix,Ct.sunShadowCascade.value=X.state.sunShadowCascade,Ct.directionalShadowMatrix.value=X.state.directionalShadowMatrix,Ct.spotLightMatrix.value=X.state.spotLightMatrix,Ct.spotLightMap.value=X.state.spotLightMap,Ct.pointShadowMatrix.value=X.state.pointShadowMatrix),H.numLightProbeGrids=qy(b.state.lightProbeGridArray),H.currentProgram=te,H.uniformsList=null,te}function kE(A,O,Y,H,X){let bt=Ut.get(A),Et=bt.currentProgram.id+","+H+","+X,xt=bt.programVariants.get(Et);return xt===void 0?(xt=Va(A,O,Y),bt.programVariants.set(Et,xt)):(bt.currentProgram=xt,bt.uniformsList=null,bt.outputColorSpace=H,bt.toneMapping=X),xt}function Yy(A){if(A.uniformsList===null){let O=A.currentProgram.getUniforms();A.uniformsList=Wo.seqWithValue(O.seq,A.uniforms)}return A.uniformsList}function Zy(A,O){let Y=Ut.get(A);Y.outputColorSpace=O.outputColorSpace,Y.batching=O.batching,Y.batchingColor=O.batchingColor,Y.instancing=O.instancing,Y.instancingColor=O.instancingColor,Y.instancingMorph=O.instancingMorph,Y.skinning=O.skinning,Y.morphTargets=O.morphTargets,Y.morphNormals=O.morphNormals,Y.morphColors=O.morphColors,Y.morphTargetsCount=O.morphTargetsCount,Y.numClippingPlanes=O.numClippingPlanes,Y.numIntersection=O.numClipIntersection,Y.vertexAlphas=O.vertexAlphas,Y.vertexTangents=O.vertexTangents,Y.toneMapping=O.toneMapping}function zE(A,O,Y,H,X){O.isScene!==!0&&(O=Wn),zt.resetTextureUnits();let bt=O.fog,Et=H.isMeshStandardMaterial||H.isMeshLambertMaterial||H.isMeshPhongMaterial?O.environment:null,xt=Z===null?C.outputColorSpace:Z.isXRRenderTarget===!0?Z.texture.colorSpace:ne.workingColorSpace,At=H.isMeshStandardMaterial||H.isMeshLambertMaterial&&!H.envMap||H.isMeshPhongMaterial&&!H.envMap,Pt=I.get(H.envMap||Et,At),Gt=H.vertexColors===!0&&!!Y.attributes.color&&Y.attributes.color.itemSize===4,te=!!Y.attributes.tangent&&(!!H.normalMap||H.anisotropy>0),Ct=!!Y.morphAttributes.position,ee=!!Y.morphAttributes.normal,Ne=!!Y.morphAttributes.color,_e=Fi;H.toneMapped&&(Z===null||Z.isXRRenderTarget===!0)&&(_e=C.toneMapping);let me=Y.morphAttributes.position||Y.morphAttributes.normal||Y.morphAttributes.color,fn=me!==void 0?me.length:0,Rt=Ut.get(H),_n=b.state.lights;if(Xt===!0&&(he===!0||A!==G)){let Te=A===G&&H.id===F;tt.setState(H,A,Te)}let se=!1,Ss=!1;H.version===Rt.__version?Rt.needsLights&&Rt.lightsStateVersion!==_n.state.version||X.isBatchedMesh&&Rt.batching===!1||!X.isBatchedMesh&&Rt.batching===!0||X.isBatchedMesh&&Rt.batchingColor===!0&&X._colorsTexture===null||X.isBatchedMesh&&Rt.batchingColor===!1&&X._colorsTexture!==null||X.isInstancedMesh&&Rt.instancing===!1||!X.isInstancedMesh&&Rt.instancing===!0||X.isSkinnedMesh&&Rt.skinning===!1||!X.isSkinnedMesh&&Rt.skinning===!0||X.isInstancedMesh&&Rt.instancingColor===!0&&X.instanceColor===null||X.isInstancedMesh&&Rt.instancingColor===!1&&X.instanceColor!==null||X.isInstancedMesh&&Rt.instancingMorph===!0&&X.morphTexture===null||X.isInstancedMesh&&Rt.instancingMorph===!1&&X.morphTexture!==null||Rt.envMap!==Pt||H.fog===!0&&Rt.fog!==bt||Rt.numClippingPlanes!==void 0&&(Rt.numClippingPlanes!==tt.numPlanes||Rt.numIntersection!==tt.numIntersection)||Rt.vertexAlphas!==Gt||Rt.vertexTangents!==te||Rt.morphTargets!==Ct||Rt.morphNormals!==ee||Rt.morphColors!==Ne||Rt.morphTargetsCount!==fn||Rt.numLightProbeGrids!==qy(b.state.lightProbeGridArray)?se=!0:(Rt.outputColorSpace!==xt||Rt.toneMapping!==_e)&&(Ss=!0):(se=!0,Rt.__version=H.version);let hn=Rt.currentProgram;(se===!0||Ss===!0)&&(hn=Ss===!0?kE(H,O,X,xt,_e):Va(H,O,X),N&&H.isNodeMaterial&&N.onUpdateProgram(H,hn,Rt));let Ul=!1,zr=!1,ws=!1,ie=hn.getUniforms(),nn=Rt.uniforms;if(St.useProgram(hn.program)&&(Ul=!0,zr=!0,ws=!0),H.id!==F&&(F=H.id,zr=!0),Ul||G!==A){St.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),ie.setValue(z,"projectionMatrix",A.projectionMatrix),ie.setValue(z,"viewMatrix",A.matrixWorldInverse);let Xe=ie.map.cameraPosition;Xe!==void 0&&Xe.setValue(z,un.setFromMatrixPosition(A.matrixWorld)),Se.logarithmicDepthBuffer&&ie.setValue(z,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(H.isMeshPhongMaterial||H.isMeshToonMaterial||H.isMeshLambertMaterial||H.isMeshBasicMaterial||H.isMeshStandardMaterial||H.isShaderMaterial)&&ie.setValue(z,"isOrthographic",A.isOrthographicCamera===!0),G!==A&&(G=A,zr=!0,ws=!0)}if(Rt.needsLights&&(_n.state.sunShadowMap.length>0&&ie.setValue(z,"sunShadowMap",_n.state.sunShadowMap,zt),_n.state.directionalShadowMap.length>0&&ie.setValue(z,"directionalShadowMap",_n.state.directionalShadowMap,zt),_n.state.spotShadowMap.length>0&&ie.setValue(z,"spotShadowMap",_n.state.spotShadowMap,zt),_n.state.pointShadowMap.length>0&&ie.setValue(z,"pointShadowMap",_n.state.pointShadowMap,zt)),X.isSkinnedMesh){ie.setOptional(z,X,"bindMatrix"),ie.setOptional(z,X,"bindMatrixInverse");let Te=X.skeleton;Te&&(Te.boneTexture===null&&Te.computeBoneTexture(),ie.setValue(z,"boneTexture",Te.boneTexture,zt))}X.isBatchedMesh&&(ie.setOptional(z,X,"batchingTexture"),ie.setValue(z,"batchingTexture",X._matricesTexture,zt),ie.setOptional(z,X,"batchingIdTexture"),ie.setValue(z,"batchingIdTexture",X._indirectTexture,zt),ie.setOptional(z,X,"batchingColorTexture"),X._colorsTexture!==null&&ie.setValue(z,"batchingColorTexture",X._colorsTexture,zt));let gi=Y.morphAttributes;if((gi.position!==void 0||gi.normal!==void 0||gi.color!==void 0)&&et.update(X,Y,hn),(zr||Rt.receiveShadow!==X.receiveShadow)&&(Rt.receiveShadow=X.receiveShadow,ie.setValue(z,"receiveShadow",X.receiveShadow)),(H.isMeshStandardMaterial||H.isMeshLambertMaterial||H.isMeshPhongMaterial)&&H.envMap===null&&O.environment!==null&&(nn.envMapIntensity.value=O.environmentIntensity),nn.dfgLUT!==void 0&&(nn.dfgLUT.value=RI()),zr){if(ie.setValue(z,"toneMappingExposure",C.toneMappingExposure),Rt.needsLights&&GE(nn,ws),bt&&H.fog===!0&&pt.refreshFogUniforms(nn,bt),pt.refreshMaterialUniforms(nn,H,at,st,b.state.transmissionRenderTarget[A.id]),Rt.needsLights&&Rt.numLightProbeGrids>0){let Te=v,Xe=0;for(let or of b.state.lightProbeGridArray)or.texture!==null&&(Te.textures[Xe]=or.texture,Te.min[Xe]=or.boundingBox.min,Te.max[Xe]=or.boundingBox.max,Te.resolution[Xe]=or.resolution,Xe++);for(let or in Te)Te[or].length=Xe;nn.probesSH.value=Te.textures,nn.probesMin.value=Te.min,nn.probesMax.value=Te.max,nn.probesResolution.value=Te.resolution}Wo.upload(z,Yy(Rt),nn,zt)}if(H.isShaderMaterial&&H.uniformsNeedUpdate===!0&&(Wo.upload(z,Yy(Rt),nn,zt),H.uniformsNeedUpdate=!1),H.isSpriteMaterial&&ie.setValue(z,"center",X.center),ie.setValue(z,"modelViewMatrix",X.modelViewMatrix),ie.setValue(z,"normalMatrix",X.normalMatrix),ie.setValue(z,"modelMatrix",X.matrixWorld),H.uniformsGroups!==void 0){let Te=H.uniformsGroups;for(let Xe=0,or=Te.length;Xe<or;Xe++){let Ky=Te[Xe];It.update(Ky,hn),It.bind(Ky,hn)}}return hn}function GE(A,O){A.ambientLightColor.needsUpdate=O,A.lightProbe.needsUpdate=O,A.sunLights.needsUpdate=O,A.sunLightShadows.needsUpdate=O,A.directionalLights.needsUpdate=O,A.directionalLightShadows.needsUpdate=O,A.pointLights.needsUpdate=O,A.pointLightShadows.needsUpdate=O,A.spotLights.needsUpdate=O,A.spotLightShadows.needsUpdate=O,A.rectAreaLights.needsUpdate=O,A.hemisphereLights.needsUpdate=O}function VE(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return B},this.getActiveMipmapLevel=function(){return U},this.getRenderTarget=function(){return Z},this.setRenderTargetTextures=function(A,O,Y){let H=Ut.get(A);H.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,H.__autoAllocateDepthBuffer===!1&&(H.__useRenderToTexture=!1),Ut.get(A.texture).__webglTexture=O,Ut.get(A.depthTexture).__webglTexture=H.__autoAllocateDepthBuffer?void 0:Y,H.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,O){let Y=Ut.get(A);Y.__webglFramebuffer=O,Y.__useDefaultFramebuffer=O===void 0},this.setRenderTarget=function(A,O=0,Y=0){Z=A,B=O,U=Y;let H=null,X=!1,bt=!1;if(A){let xt=Ut.get(A);if(xt.__useDefaultFramebuffer!==void 0){St.bindFramebuffer(z.FRAMEBUFFER,xt.__webglFramebuffer),q.copy(A.viewport),rt.copy(A.scissor),ct=A.scissorTest,St.viewport(q),St.scissor(rt),St.setScissorTest(ct),F=-1;return}else if(xt.__webglFramebuffer===void 0)zt.setupRenderTarget(A);else if(xt.__hasExternalTextures)zt.rebindTextures(A,Ut.get(A.texture).__webglTexture,Ut.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let Gt=A.depthTexture;if(xt.__boundDepthTexture!==Gt){if(Gt!==null&&Ut.has(Gt)&&(A.width!==Gt.image.width||A.height!==Gt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");zt.setupDepthRenderbuffer(A)}}let At=A.texture;(At.isData3DTexture||At.isDataArrayTexture||At.isCompressedArrayTexture)&&(bt=!0);let Pt=Ut.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(Pt[O])?H=Pt[O][Y]:H=Pt[O],X=!0):A.samples>0&&zt.useMultisampledRTT(A)===!1?H=Ut.get(A).__webglMultisampledFramebuffer:Array.isArray(Pt)?H=Pt[Y]:H=Pt,q.copy(A.viewport),rt.copy(A.scissor),ct=A.scissorTest}else q.copy(lt).multiplyScalar(at).floor(),rt.copy(K).multiplyScalar(at).floor(),ct=Lt;if(Y!==0&&(H=k),St.bindFramebuffer(z.FRAMEBUFFER,H)&&St.drawBuffers(A,H),St.viewport(q),St.scissor(rt),St.setScissorTest(ct),X){let xt=Ut.get(A.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_CUBE_MAP_POSITIVE_X+O,xt.__webglTexture,Y)}else if(bt){let xt=O;for(let At=0;At<A.textures.length;At++){let Pt=Ut.get(A.textures[At]);z.framebufferTextureLayer(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0+At,Pt.__webglTexture,Y,xt)}}else if(A!==null&&Y!==0){let xt=Ut.get(A.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,xt.__webglTexture,Y)}F=-1};function Jy(A){let O=Ut.get(A);return(O.__readFormat!==A.format||O.__readType!==A.type)&&(O.__readFormat=A.format,O.__readType=A.type,O.__formatReadable=Se.textureFormatReadable(A.format),O.__typeReadable=Se.textureTypeReadable(A.type)),O}this.readRenderTargetPixels=function(A,O,Y,H,X,bt,Et,xt=0){if(!(A&&A.isWebGLRenderTarget)){Ot("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let At=Ut.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Et!==void 0&&(At=At[Et],Array.isArray(At)&&(At=At[0])),At){St.bindFramebuffer(z.FRAMEBUFFER,At);try{let Pt=A.textures[xt],Gt=Pt.format,te=Pt.type;A.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+xt);let Ct=Jy(Pt);if(Ct.__formatReadable===!1){Ot("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ct.__typeReadable===!1){Ot("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}O>=0&&O<=A.width-H&&Y>=0&&Y<=A.height-X&&z.readPixels(O,Y,H,X,dt.convert(Gt),dt.convert(te),bt)}finally{let Pt=Z!==null?Ut.get(Z).__webglFramebuffer:null;St.bindFramebuffer(z.FRAMEBUFFER,Pt)}}},this.readRenderTargetPixelsAsync=async function(A,O,Y,H,X,bt,Et,xt=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let At=Ut.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Et!==void 0&&(At=At[Et],Array.isArray(At)&&(At=At[0])),At)if(O>=0&&O<=A.width-H&&Y>=0&&Y<=A.height-X){St.bindFramebuffer(z.FRAMEBUFFER,At);let Pt=A.textures[xt],Gt=Pt.format,te=Pt.type;A.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+xt);let Ct=Jy(Pt);if(Ct.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ct.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ee=z.createBuffer();z.bindBuffer(z.PIXEL_PACK_BUFFER,ee),z.bufferData(z.PIXEL_PACK_BUFFER,bt.byteLength,z.STREAM_READ),z.readPixels(O,Y,H,X,dt.convert(Gt),dt.convert(te),0),z.bindBuffer(z.PIXEL_PACK_BUFFER,null);let Ne=Z!==null?Ut.get(Z).__webglFramebuffer:null;St.bindFramebuffer(z.FRAMEBUFFER,Ne);let _e=z.fenceSync(z.SYNC_GPU_COMMANDS_COMPLETE,0);return z.flush(),await lv(z,_e,4),z.bindBuffer(z.PIXEL_PACK_BUFFER,ee),z.getBufferSubData(z.PIXEL_PACK_BUFFER,0,bt),z.bindBuffer(z.PIXEL_PACK_BUFFER,null),z.deleteBuffer(ee),z.deleteSync(_e),bt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,O=null,Y=0){let H=Math.pow(2,-Y),X=Math.floor(A.image.width*H),bt=Math.floor(A.image.height*H),Et=O!==null?O.x:0,xt=O!==null?O.y:0;zt.setTexture2D(A,0),z.copyTexSubImage2D(z.TEXTURE_2D,Y,0,0,Et,xt,X,bt),St.unbindTexture()},this.copyTextureToTexture=function(A,O,Y=null,H=null,X=0,bt=0){let Et,xt,At,Pt,Gt,te,Ct,ee,Ne,_e=A.isCompressedTexture?A.mipmaps[bt]:A.image;if(Y!==null)Et=Y.max.x-Y.min.x,xt=Y.max.y-Y.min.y,At=Y.isBox3?Y.max.z-Y.min.z:1,Pt=Y.min.x,Gt=Y.min.y,te=Y.isBox3?Y.min.z:0;else{let ie=Math.pow(2,-X);Et=Math.floor(_e.width*ie),xt=Math.floor(_e.height*ie),A.isDataArrayTexture?At=_e.depth:A.isData3DTexture?At=Math.floor(_e.depth*ie):At=1,Pt=0,Gt=0,te=0}H!==null?(Ct=H.x,ee=H.y,Ne=H.z):(Ct=0,ee=0,Ne=0);let me=dt.convert(O.format),fn=dt.convert(O.type),Rt;O.isData3DTexture?(zt.setTexture3D(O,0),Rt=z.TEXTURE_3D):O.isDataArrayTexture||O.isCompressedArrayTexture?(zt.setTexture2DArray(O,0),Rt=z.TEXTURE_2D_ARRAY):(zt.setTexture2D(O,0),Rt=z.TEXTURE_2D),St.activeTexture(z.TEXTURE0),St.pixelStorei(z.UNPACK_FLIP_Y_WEBGL,O.flipY),St.pixelStorei(z.UNPACK_PREMULTIPLY_ALPHA_WEBGL,O.premultiplyAlpha),St.pixelStorei(z.UNPACK_ALIGNMENT,O.unpackAlignment);let _n=St.getParameter(z.UNPACK_ROW_LENGTH),se=St.getParameter(z.UNPACK_IMAGE_HEIGHT),Ss=St.getParameter(z.UNPACK_SKIP_PIXELS),hn=St.getParameter(z.UNPACK_SKIP_ROWS),Ul=St.getParameter(z.UNPACK_SKIP_IMAGES);St.pixelStorei(z.UNPACK_ROW_LENGTH,_e.width),St.pixelStorei(z.UNPACK_IMAGE_HEIGHT,_e.height),St.pixelStorei(z.UNPACK_SKIP_PIXELS,Pt),St.pixelStorei(z.UNPACK_SKIP_ROWS,Gt),St.pixelStorei(z.UNPACK_SKIP_IMAGES,te);let zr=A.isDataArrayTexture||A.isData3DTexture,ws=O.isDataArrayTexture||O.isData3DTexture;if(A.isDepthTexture){let ie=Ut.get(A),nn=Ut.get(O),gi=Ut.get(ie.__renderTarget),Te=Ut.get(nn.__renderTarget);St.bindFramebuffer(z.READ_FRAMEBUFFER,gi.__webglFramebuffer),St.bindFramebuffer(z.DRAW_FRAMEBUFFER,Te.__webglFramebuffer);for(let Xe=0;Xe<At;Xe++)zr&&(z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Ut.get(A).__webglTexture,X,te+Xe),z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Ut.get(O).__webglTexture,bt,Ne+Xe)),z.blitFramebuffer(Pt,Gt,Pt+Et,Gt+xt,Ct,ee,Ct+Et,ee+xt,z.DEPTH_BUFFER_BIT,z.NEAREST);St.bindFramebuffer(z.READ_FRAMEBUFFER,null),St.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else if(X!==0||A.isRenderTargetTexture||Ut.has(A)){let ie=Ut.get(A),nn=Ut.get(O);St.bindFramebuffer(z.READ_FRAMEBUFFER,P),St.bindFramebuffer(z.DRAW_FRAMEBUFFER,L);for(let gi=0;gi<At;gi++)zr?z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,ie.__webglTexture,X,te+gi):z.framebufferTexture2D(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,ie.__webglTexture,X),ws?z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,nn.__webglTexture,bt,Ne+gi):z.framebufferTexture2D(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,nn.__webglTexture,bt),X!==0?z.blitFramebuffer(Pt,Gt,Pt+Et,Gt+xt,Ct,ee,Ct+Et,ee+xt,z.COLOR_BUFFER_BIT,z.NEAREST):ws?z.copyTexSubImage3D(Rt,bt,Ct,ee,Ne+gi,Pt,Gt,Et,xt):z.copyTexSubImage2D(Rt,bt,Ct,ee,Pt,Gt,Et,xt);St.bindFramebuffer(z.READ_FRAMEBUFFER,null),St.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else ws?A.isDataTexture||A.isData3DTexture?z.texSubImage3D(Rt,bt,Ct,ee,Ne,Et,xt,At,me,fn,_e.data):O.isCompressedArrayTexture?z.compressedTexSubImage3D(Rt,bt,Ct,ee,Ne,Et,xt,At,me,_e.data):z.texSubImage3D(Rt,bt,Ct,ee,Ne,Et,xt,At,me,fn,_e):A.isDataTexture?z.texSubImage2D(z.TEXTURE_2D,bt,Ct,ee,Et,xt,me,fn,_e.data):A.isCompressedTexture?z.compressedTexSubImage2D(z.TEXTURE_2D,bt,Ct,ee,_e.width,_e.height,me,_e.data):z.texSubImage2D(z.TEXTURE_2D,bt,Ct,ee,Et,xt,me,fn,_e);St.pixelStorei(z.UNPACK_ROW_LENGTH,_n),St.pixelStorei(z.UNPACK_IMAGE_HEIGHT,se),St.pixelStorei(z.UNPACK_SKIP_PIXELS,Ss),St.pixelStorei(z.UNPACK_SKIP_ROWS,hn),St.pixelStorei(z.UNPACK_SKIP_IMAGES,Ul),bt===0&&O.generateMipmaps===!0&&O.mipmapsAutoUpdate===!0&&z.generateMipmap(Rt),St.unbindTexture()},this.initRenderTarget=function(A){Ut.get(A).__webglFramebuffer===void 0&&zt.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?zt.setTextureCube(A,0):A.isData3DTexture?zt.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?zt.setTexture2DArray(A,0):zt.setTexture2D(A,0),St.unbindTexture()},this.resetState=function(){B=0,U=0,Z=null,St.reset(),mt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Zn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let n=this.getContext();n.drawingBufferColorSpace=ne._getDrawingBufferColorSpace(t),n.unpackColorSpace=ne._getUnpackColorSpace()}};var Zv={type:"change"},om={type:"start"},Kv={type:"end"},Nf=new Yr,Jv=new xn,PI=Math.cos(70*kp.DEG2RAD),Be=new V,Cn=2*Math.PI,oe={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},sm=1e-6,Df=class extends xc{constructor(t,n=null){super(t,n),this.state=oe.NONE,this.target=new V,this.cursor=new V,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:ts.ROTATE,MIDDLE:ts.DOLLY,RIGHT:ts.PAN},this.touches={ONE:es.ROTATE,TWO:es.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new V,this._lastQuaternion=new On,this._lastTargetPosition=new V,this._quat=new On().setFromUnitVectors(t.up,new V(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Qr,this._sphericalDelta=new Qr,this._scale=1,this._panOffset=new V,this._rotateStart=new Ft,this._rotateEnd=new Ft,this._rotateDelta=new Ft,this._panStart=new Ft,this._panEnd=new Ft,this._panDelta=new Ft,this._dollyStart=new Ft,this._dollyEnd=new Ft,this._dollyDelta=new Ft,this._dollyDirection=new V,this._mouse=new Ft,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=LI.bind(this),this._onPointerDown=II.bind(this),this._onPointerUp=NI.bind(this),this._onContextMenu=zI.bind(this),this._onMouseWheel=FI.bind(this),this._onKeyDown=OI.bind(this),this._onTouchStart=BI.bind(this),this._onTouchMove=kI.bind(this),this._onMouseDown=DI.bind(this),this._onMouseMove=UI.bind(this),this._interceptControlDown=GI.bind(this),this._interceptControlUp=VI.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=oe.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Zv),this.update(),this.state=oe.NONE}pan(t,n){this._pan(t,n),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let n=this.object.position;Be.copy(n).sub(this.target),Be.applyQuaternion(this._quat),this._spherical.setFromVector3(Be),this.autoRotate&&this.state===oe.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,r=this.maxAzimuthAngle;isFinite(i)&&isFinite(r)&&(i<-Math.PI?i+=Cn:i>Math.PI&&(i-=Cn),r<-Math.PI?r+=Cn:r>Math.PI&&(r-=Cn),i<=r?this._spherical.theta=Math.max(i,Math.min(r,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+r)/2?Math.max(i,this._spherical.theta):Math.min(r,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let s=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),s=o!=this._spherical.radius}if(Be.setFromSpherical(this._spherical),Be.applyQuaternion(this._quatInverse),n.copy(this.target).add(Be),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Be.length();o=this._clampDistance(a*this._scale);let c=a-o;this.object.position.addScaledVector(this._dollyDirection,c),this.object.updateMatrixWorld(),s=!!c}else if(this.object.isOrthographicCamera){let a=new V(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let c=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),s=c!==this.object.zoom;let l=new V(this._mouse.x,this._mouse.y,0);l.unproject(this.object),this.object.position.sub(l).add(a),this.object.updateMatrixWorld(),o=Be.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Nf.origin.copy(this.object.position),Nf.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Nf.direction))<PI?this.object.lookAt(this.target):(Jv.setFromNormalAndCoplanarPoint(this.object.up,this.target),Nf.intersectPlane(Jv,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),s=!0)}return this._scale=1,this._performCursorZoom=!1,s||this._lastPosition.distanceToSquared(this.object.position)>sm||8*(1-this._lastQuaternion.dot(this.object.quaternion))>sm||this._lastTargetPosition.distanceToSquared(this.target)>sm?(this.dispatchEvent(Zv),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Cn/60*this.autoRotateSpeed*t:Cn/60/60*this.autoRotateSpeed}_getZoomScale(t){let n=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*n)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,n){Be.setFromMatrixColumn(n,0),Be.multiplyScalar(-t),this._panOffset.add(Be)}_panUp(t,n){this.screenSpacePanning===!0?Be.setFromMatrixColumn(n,1):(Be.setFromMatrixColumn(n,0),Be.crossVectors(this.object.up,Be)),Be.multiplyScalar(t),this._panOffset.add(Be)}_pan(t,n){let i=this.domElement;if(this.object.isPerspectiveCamera){let r=this.object.position;Be.copy(r).sub(this.target);let s=Be.length();s*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*s/i.clientHeight,this.object.matrix),this._panUp(2*n*s/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(n*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,n){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),r=t-i.left,s=n-i.top,o=i.width,a=i.height;this._mouse.x=r/o*2-1,this._mouse.y=-(s/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let n=this.domElement;this._rotateLeft(Cn*this._rotateDelta.x/n.clientHeight),this._rotateUp(Cn*this._rotateDelta.y/n.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let n=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Cn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),n=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Cn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),n=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Cn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),n=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Cn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),n=!0;break}n&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),i=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateStart.set(i,r)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),i=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._panStart.set(i,r)}}_handleTouchStartDolly(t){let n=this._getSecondPointerPosition(t),i=t.pageX-n.x,r=t.pageY-n.y,s=Math.sqrt(i*i+r*r);this._dollyStart.set(0,s)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),r=.5*(t.pageX+i.x),s=.5*(t.pageY+i.y);this._rotateEnd.set(r,s)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let n=this.domElement;this._rotateLeft(Cn*this._rotateDelta.x/n.clientHeight),this._rotateUp(Cn*this._rotateDelta.y/n.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),i=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._panEnd.set(i,r)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let n=this._getSecondPointerPosition(t),i=t.pageX-n.x,r=t.pageY-n.y,s=Math.sqrt(i*i+r*r);this._dollyEnd.set(0,s),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+n.x)*.5,a=(t.pageY+n.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let n=0;n<this._pointers.length;n++)if(this._pointers[n]==t.pointerId){this._pointers.splice(n,1);return}}_isTrackingPointer(t){for(let n=0;n<this._pointers.length;n++)if(this._pointers[n]==t.pointerId)return!0;return!1}_trackPointer(t){let n=this._pointerPositions[t.pointerId];n===void 0&&(n=new Ft,this._pointerPositions[t.pointerId]=n),n.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let n=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[n]}_customWheelEvent(t){let n=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(n){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function II(e){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(e.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(e)&&(this._addPointer(e),e.pointerType==="touch"?this._onTouchStart(e):this._onMouseDown(e),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function LI(e){this.enabled!==!1&&(e.pointerType==="touch"?this._onTouchMove(e):this._onMouseMove(e))}function NI(e){switch(this._removePointer(e),this._pointers.length){case 0:this.domElement.releasePointerCapture(e.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Kv),this.state=oe.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],n=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:n.x,pageY:n.y});break}}function DI(e){let t;switch(e.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case ts.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(e),this.state=oe.DOLLY;break;case ts.ROTATE:if(e.ctrlKey||e.metaKey||e.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(e),this.state=oe.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(e),this.state=oe.ROTATE}break;case ts.PAN:if(e.ctrlKey||e.metaKey||e.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(e),this.state=oe.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(e),this.state=oe.PAN}break;default:this.state=oe.NONE}this.state!==oe.NONE&&this.dispatchEvent(om)}function UI(e){switch(this.state){case oe.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(e);break;case oe.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(e);break;case oe.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(e);break}}function FI(e){this.enabled===!1||this.enableZoom===!1||this.state!==oe.NONE||(e.preventDefault(),this.dispatchEvent(om),this._handleMouseWheel(this._customWheelEvent(e)),this.dispatchEvent(Kv))}function OI(e){this.enabled!==!1&&this._handleKeyDown(e)}function BI(e){switch(this._trackPointer(e),this._pointers.length){case 1:switch(this.touches.ONE){case es.ROTATE:if(this.enableRotate===!1){this.state=oe.NONE;break}this._handleTouchStartRotate(e),this.state=oe.TOUCH_ROTATE;break;case es.PAN:if(this.enablePan===!1){this.state=oe.NONE;break}this._handleTouchStartPan(e),this.state=oe.TOUCH_PAN;break;default:this.state=oe.NONE}break;case 2:switch(this.touches.TWO){case es.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(e),this.state=oe.TOUCH_DOLLY_PAN;break;case es.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(e),this.state=oe.TOUCH_DOLLY_ROTATE;break;default:this.state=oe.NONE}break;default:this.state=oe.NONE}this.state!==oe.NONE&&this.dispatchEvent(om)}function kI(e){switch(this._trackPointer(e),this.state){case oe.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(e),this.update();break;case oe.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(e),this.update();break;case oe.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(e),this.update();break;case oe.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(e),this.update();break;default:this.state=oe.NONE}}function zI(e){this.enabled!==!1&&e.preventDefault()}function GI(e){e.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function VI(e){e.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function gn(e,t){return e==null||t==null?NaN:e<t?-1:e>t?1:e>=t?0:NaN}function br(e,t){return e==null||t==null?NaN:t<e?-1:t>e?1:t>=e?0:NaN}function Yo(e){let t,n,i;e.length!==2?(t=gn,n=(a,c)=>gn(e(a),c),i=(a,c)=>e(a)-c):(t=e===gn||e===br?e:HI,n=e,i=e);function r(a,c,l=0,u=a.length){if(l<u){if(t(c,c)!==0)return u;do{let h=l+u>>>1;n(a[h],c)<0?l=h+1:u=h}while(l<u)}return l}function s(a,c,l=0,u=a.length){if(l<u){if(t(c,c)!==0)return u;do{let h=l+u>>>1;n(a[h],c)<=0?l=h+1:u=h}while(l<u)}return l}function o(a,c,l=0,u=a.length){let h=r(a,c,l,u-1);return h>l&&i(a[h-1],c)>-i(a[h],c)?h-1:h}return{left:r,center:o,right:s}}function HI(){return 0}function jv(e){return e===null?NaN:+e}function*WI(e,t){if(t===void 0)for(let n of e)n!=null&&(n=+n)>=n&&(yield n);else{let n=-1;for(let i of e)(i=t(i,++n,e))!=null&&(i=+i)>=i&&(yield i)}}var Qv=Yo(gn),Bf=Qv.right,Rk=Qv.left,Pk=Yo(jv).center;var Ik=tb(eb),Lk=tb($I);function tb(e){return function(t,n,i=n){if(!((n=+n)>=0))throw new RangeError("invalid rx");if(!((i=+i)>=0))throw new RangeError("invalid ry");let{data:r,width:s,height:o}=t;if(!((s=Math.floor(s))>=0))throw new RangeError("invalid width");if(!((o=Math.floor(o!==void 0?o:r.length/s))>=0))throw new RangeError("invalid height");if(!s||!o||!n&&!i)return t;let a=n&&e(n),c=i&&e(i),l=r.slice();return a&&c?(Xo(a,l,r,s,o),Xo(a,r,l,s,o),Xo(a,l,r,s,o),qo(c,r,l,s,o),qo(c,l,r,s,o),qo(c,r,l,s,o)):a?(Xo(a,r,l,s,o),Xo(a,l,r,s,o),Xo(a,r,l,s,o)):c&&(qo(c,r,l,s,o),qo(c,l,r,s,o),qo(c,r,l,s,o)),t}}function Xo(e,t,n,i,r){for(let s=0,o=i*r;s<o;)e(t,n,s,s+=i,1)}function qo(e,t,n,i,r){for(let s=0,o=i*r;s<i;++s)e(t,n,s,s+o,i)}function $I(e){let t=eb(e);return(n,i,r,s,o)=>{r<<=2,s<<=2,o<<=2,t(n,i,r+0,s+0,o),t(n,i,r+1,s+1,o),t(n,i,r+2,s+2,o),t(n,i,r+3,s+3,o)}}function eb(e){let t=Math.floor(e);if(t===e)return XI(e);let n=e-t,i=2*e+1;return(r,s,o,a,c)=>{if(!((a-=c)>=o))return;let l=t*s[o],u=c*t,h=u+c;for(let f=o,d=o+u;f<d;f+=c)l+=s[Math.min(a,f)];for(let f=o,d=a;f<=d;f+=c)l+=s[Math.min(a,f+u)],r[f]=(l+n*(s[Math.max(o,f-h)]+s[Math.min(a,f+h)]))/i,l-=s[Math.max(o,f-u)]}}function XI(e){let t=2*e+1;return(n,i,r,s,o)=>{if(!((s-=o)>=r))return;let a=e*i[r],c=o*e;for(let l=r,u=r+c;l<u;l+=o)a+=i[Math.min(s,l)];for(let l=r,u=s;l<=u;l+=o)a+=i[Math.min(s,l+c)],n[l]=a/t,a-=i[Math.max(r,l-c)]}}function qI(e){return e.length|0}function YI(e){return!(e>0)}function ZI(e){return typeof e!="object"||"length"in e?e:Array.from(e)}function JI(e){return t=>e(...t)}function nb(...e){let t=typeof e[e.length-1]=="function"&&JI(e.pop());e=e.map(ZI);let n=e.map(qI),i=e.length-1,r=new Array(i+1).fill(0),s=[];if(i<0||n.some(YI))return s;for(;;){s.push(r.map((a,c)=>e[c][a]));let o=i;for(;++r[o]===n[o];){if(o===0)return t?s.map(t):s;r[o--]=0}}}function ib(e,t){var n=0,i=0;return Float64Array.from(e,t===void 0?r=>n+=+r||0:r=>n+=+t(r,i++,e)||0)}function lm(e,t){let n=0,i,r=0,s=0;if(t===void 0)for(let o of e)o!=null&&(o=+o)>=o&&(i=o-r,r+=i/++n,s+=i*(o-r));else{let o=-1;for(let a of e)(a=t(a,++o,e))!=null&&(a=+a)>=a&&(i=a-r,r+=i/++n,s+=i*(a-r))}if(n>1)return s/(n-1)}function rb(e,t){let n=lm(e,t);return n&&Math.sqrt(n)}function ni(e,t){let n,i;if(t===void 0)for(let r of e)r!=null&&(n===void 0?r>=r&&(n=i=r):(n>r&&(n=r),i<r&&(i=r)));else{let r=-1;for(let s of e)(s=t(s,++r,e))!=null&&(n===void 0?s>=s&&(n=i=s):(n>s&&(n=s),i<s&&(i=s)))}return[n,i]}var Qn=class{constructor(){this._partials=new Float64Array(32),this._n=0}add(t){let n=this._partials,i=0;for(let r=0;r<this._n&&r<32;r++){let s=n[r],o=t+s,a=Math.abs(t)<Math.abs(s)?t-(o-s):s-(o-t);a&&(n[i++]=a),t=o}return n[i]=t,this._n=i+1,this}valueOf(){let t=this._partials,n=this._n,i,r,s,o=0;if(n>0){for(o=t[--n];n>0&&(i=o,r=t[--n],o=i+r,s=r-(o-i),!s););n>0&&(s<0&&t[n-1]<0||s>0&&t[n-1]>0)&&(r=s*2,i=o+r,r==i-o&&(o=i))}return o}};var ti=class extends Map{constructor(t,n=ab){if(super(),Object.defineProperties(this,{_intern:{value:new Map},_key:{value:n}}),t!=null)for(let[i,r]of t)this.set(i,r)}get(t){return super.get(am(this,t))}has(t){return super.has(am(this,t))}set(t,n){return super.set(sb(this,t),n)}delete(t){return super.delete(ob(this,t))}},ki=class extends Set{constructor(t,n=ab){if(super(),Object.defineProperties(this,{_intern:{value:new Map},_key:{value:n}}),t!=null)for(let i of t)this.add(i)}has(t){return super.has(am(this,t))}add(t){return super.add(sb(this,t))}delete(t){return super.delete(ob(this,t))}};function am({_intern:e,_key:t},n){let i=t(n);return e.has(i)?e.get(i):n}function sb({_intern:e,_key:t},n){let i=t(n);return e.has(i)?e.get(i):(e.set(i,n),n)}function ob({_intern:e,_key:t},n){let i=t(n);return e.has(i)&&(n=e.get(i),e.delete(i)),n}function ab(e){return e!==null&&typeof e=="object"?e.valueOf():e}function cm(e){return e}function Zo(e,...t){return um(e,cm,cm,t)}function is(e,t,...n){return um(e,cm,t,n)}function cb(e,t,...n){return um(e,Array.from,t,n)}function um(e,t,n,i){return(function r(s,o){if(o>=i.length)return n(s);let a=new ti,c=i[o++],l=-1;for(let u of s){let h=c(u,++l,s),f=a.get(h);f?f.push(u):a.set(h,[u])}for(let[u,h]of a)a.set(u,r(h,o));return t(a)})(e,0)}function KI(e,t){return Array.from(t,n=>e[n])}function Nc(e,...t){if(typeof e[Symbol.iterator]!="function")throw new TypeError("values is not iterable");e=Array.from(e);let[n]=t;if(n&&n.length!==2||t.length>1){let i=Uint32Array.from(e,(r,s)=>s);return t.length>1?(t=t.map(r=>e.map(r)),i.sort((r,s)=>{for(let o of t){let a=Uf(o[r],o[s]);if(a)return a}})):(n=e.map(n),i.sort((r,s)=>Uf(n[r],n[s]))),KI(e,i)}return e.sort(lb(n))}function lb(e=gn){if(e===gn)return Uf;if(typeof e!="function")throw new TypeError("compare is not a function");return(t,n)=>{let i=e(t,n);return i||i===0?i:(e(n,n)===0)-(e(t,t)===0)}}function Uf(e,t){return(e==null||!(e>=e))-(t==null||!(t>=t))||(e<t?-1:e>t?1:0)}function kf(e,t,n){return(t.length!==2?Nc(is(e,t,n),(([i,r],[s,o])=>gn(r,o)||gn(i,s))):Nc(Zo(e,n),(([i,r],[s,o])=>t(r,o)||gn(i,s)))).map(([i])=>i)}var jI=Array.prototype,Nk=jI.slice;var QI=Math.sqrt(50),tL=Math.sqrt(10),eL=Math.sqrt(2);function Ff(e,t,n){let i=(t-e)/Math.max(0,n),r=Math.floor(Math.log10(i)),s=i/Math.pow(10,r),o=s>=QI?10:s>=tL?5:s>=eL?2:1,a,c,l;return r<0?(l=Math.pow(10,-r)/o,a=Math.round(e*l),c=Math.round(t*l),a/l<e&&++a,c/l>t&&--c,l=-l):(l=Math.pow(10,r)*o,a=Math.round(e/l),c=Math.round(t/l),a*l<e&&++a,c*l>t&&--c),c<a&&.5<=n&&n<2?Ff(e,t,n*2):[a,c,l]}function Jo(e,t,n){if(t=+t,e=+e,n=+n,!(n>0))return[];if(e===t)return[e];let i=t<e,[r,s,o]=i?Ff(t,e,n):Ff(e,t,n);if(!(s>=r))return[];let a=s-r+1,c=new Array(a);if(i)if(o<0)for(let l=0;l<a;++l)c[l]=(s-l)/-o;else for(let l=0;l<a;++l)c[l]=(s-l)*o;else if(o<0)for(let l=0;l<a;++l)c[l]=(r+l)/-o;else for(let l=0;l<a;++l)c[l]=(r+l)*o;return c}function Of(e,t,n){return t=+t,e=+e,n=+n,Ff(e,t,n)[2]}function Dc(e,t,n){t=+t,e=+e,n=+n;let i=t<e,r=i?Of(t,e,n):Of(e,t,n);return(i?-1:1)*(r<0?1/-r:r)}function bn(e,t){let n;if(t===void 0)for(let i of e)i!=null&&(n<i||n===void 0&&i>=i)&&(n=i);else{let i=-1;for(let r of e)(r=t(r,++i,e))!=null&&(n<r||n===void 0&&r>=r)&&(n=r)}return n}function ub(e,t){let n,i=-1,r=-1;if(t===void 0)for(let s of e)++r,s!=null&&(n<s||n===void 0&&s>=s)&&(n=s,i=r);else for(let s of e)(s=t(s,++r,e))!=null&&(n<s||n===void 0&&s>=s)&&(n=s,i=r);return i}function ei(e,t){let n;if(t===void 0)for(let i of e)i!=null&&(n>i||n===void 0&&i>=i)&&(n=i);else{let i=-1;for(let r of e)(r=t(r,++i,e))!=null&&(n>r||n===void 0&&r>=r)&&(n=r)}return n}function fb(e,t){let n,i=-1,r=-1;if(t===void 0)for(let s of e)++r,s!=null&&(n>s||n===void 0&&s>=s)&&(n=s,i=r);else for(let s of e)(s=t(s,++r,e))!=null&&(n>s||n===void 0&&s>=s)&&(n=s,i=r);return i}function hb(e,t,n=0,i=1/0,r){if(t=Math.floor(t),n=Math.floor(Math.max(0,n)),i=Math.floor(Math.min(e.length-1,i)),!(n<=t&&t<=i))return e;for(r=r===void 0?Uf:lb(r);i>n;){if(i-n>600){let c=i-n+1,l=t-n+1,u=Math.log(c),h=.5*Math.exp(2*u/3),f=.5*Math.sqrt(u*h*(c-h)/c)*(l-c/2<0?-1:1),d=Math.max(n,Math.floor(t-l*h/c+f)),p=Math.min(i,Math.floor(t+(c-l)*h/c+f));hb(e,t,d,p,r)}let s=e[t],o=n,a=i;for(Lc(e,n,t),r(e[i],s)>0&&Lc(e,n,i);o<a;){for(Lc(e,o,a),++o,--a;r(e[o],s)<0;)++o;for(;r(e[a],s)>0;)--a}r(e[n],s)===0?Lc(e,n,a):(++a,Lc(e,a,i)),a<=t&&(n=a+1),t<=a&&(i=a-1)}return e}function Lc(e,t,n){let i=e[t];e[t]=e[n],e[n]=i}function fm(e,t=gn){let n,i=!1;if(t.length===1){let r;for(let s of e){let o=t(s);(i?gn(o,r)>0:gn(o,o)===0)&&(n=s,r=o,i=!0)}}else for(let r of e)(i?t(r,n)>0:t(r,r)===0)&&(n=r,i=!0);return n}function Us(e,t,n){if(e=Float64Array.from(WI(e,n)),!(!(i=e.length)||isNaN(t=+t))){if(t<=0||i<2)return ei(e);if(t>=1)return bn(e);var i,r=(i-1)*t,s=Math.floor(r),o=bn(hb(e,s).subarray(0,s+1)),a=ei(e.subarray(s+1));return o+(a-o)*(r-s)}}function db(e,t,n=jv){if(!(!(i=e.length)||isNaN(t=+t))){if(t<=0||i<2)return+n(e[0],0,e);if(t>=1)return+n(e[i-1],i-1,e);var i,r=(i-1)*t,s=Math.floor(r),o=+n(e[s],s,e),a=+n(e[s+1],s+1,e);return o+(a-o)*(r-s)}}function pb(e,t){let n=0,i=0;if(t===void 0)for(let r of e)r!=null&&(r=+r)>=r&&(++n,i+=r);else{let r=-1;for(let s of e)(s=t(s,++r,e))!=null&&(s=+s)>=s&&(++n,i+=s)}if(n)return i/n}function Uc(e,t){return Us(e,.5,t)}function*nL(e){for(let t of e)yield*t}function hm(e){return Array.from(nL(e))}function mb(e,t){let n=new ti;if(t===void 0)for(let s of e)s!=null&&s>=s&&n.set(s,(n.get(s)||0)+1);else{let s=-1;for(let o of e)(o=t(o,++s,e))!=null&&o>=o&&n.set(o,(n.get(o)||0)+1)}let i,r=0;for(let[s,o]of n)o>r&&(r=o,i=s);return i}function gb(e,t=iL){let n=[],i,r=!1;for(let s of e)r&&n.push(t(i,s)),i=s,r=!0;return n}function iL(e,t){return[e,t]}function Ko(e,t,n){e=+e,t=+t,n=(r=arguments.length)<2?(t=e,e=0,1):r<3?1:+n;for(var i=-1,r=Math.max(0,Math.ceil((t-e)/n))|0,s=new Array(r);++i<r;)s[i]=e+i*n;return s}var Dk=rL(Math.random);function rL(e){return function(n,i=0,r=n.length){let s=r-(i=+i);for(;s;){let o=e()*s--|0,a=n[s+i];n[s+i]=n[o+i],n[o+i]=a}return n}}function zi(e,t){let n=0;if(t===void 0)for(let i of e)(i=+i)&&(n+=i);else{let i=-1;for(let r of e)(r=+t(r,++i,e))&&(n+=r)}return n}function jo(e){if(typeof e[Symbol.iterator]!="function")throw new TypeError("values is not iterable");return Array.from(e).reverse()}function sL(e){return e}var dm=1,pm=2,mm=3,zf=4,_b=1e-6;function oL(e){return"translate("+e+",0)"}function aL(e){return"translate(0,"+e+")"}function cL(e){return t=>+e(t)}function lL(e,t){return t=Math.max(0,e.bandwidth()-t*2)/2,e.round()&&(t=Math.round(t)),n=>+e(n)+t}function uL(){return!this.__axis}function fL(e,t){var n=[],i=null,r=null,s=6,o=6,a=3,c=typeof window<"u"&&window.devicePixelRatio>1?0:.5,l=e===dm||e===zf?-1:1,u=e===zf||e===pm?"x":"y",h=e===dm||e===mm?oL:aL;function f(d){var p=i??(t.ticks?t.ticks.apply(t,n):t.domain()),_=r??(t.tickFormat?t.tickFormat.apply(t,n):sL),g=Math.max(s,0)+a,m=t.range(),x=+m[0]+c,S=+m[m.length-1]+c,v=(t.bandwidth?lL:cL)(t.copy(),c),w=d.selection?d.selection():d,b=w.selectAll(".domain").data([null]),y=w.selectAll(".tick").data(p,t).order(),M=y.exit(),R=y.enter().append("g").attr("class","tick"),C=y.select("line"),E=y.select("text");b=b.merge(b.enter().insert("path",".tick").attr("class","domain").attr("stroke","currentColor")),y=y.merge(R),C=C.merge(R.append("line").attr("stroke","currentColor").attr(u+"2",l*s)),E=E.merge(R.append("text").attr("fill","currentColor").attr(u,l*g).attr("dy",e===dm?"0em":e===mm?"0.71em":"0.32em")),d!==w&&(b=b.transition(d),y=y.transition(d),C=C.transition(d),E=E.transition(d),M=M.transition(d).attr("opacity",_b).attr("transform",function(N){return isFinite(N=v(N))?h(N+c):this.getAttribute("transform")}),R.attr("opacity",_b).attr("transform",function(N){var k=this.parentNode.__axis;return h((k&&isFinite(k=k(N))?k:v(N))+c)})),M.remove(),b.attr("d",e===zf||e===pm?o?"M"+l*o+","+x+"H"+c+"V"+S+"H"+l*o:"M"+c+","+x+"V"+S:o?"M"+x+","+l*o+"V"+c+"H"+S+"V"+l*o:"M"+x+","+c+"H"+S),y.attr("opacity",1).attr("transform",function(N){return h(v(N)+c)}),C.attr(u+"2",l*s),E.attr(u,l*g).text(_),w.filter(uL).attr("fill","none").attr("font-size",10).attr("font-family","sans-serif").attr("text-anchor",e===pm?"start":e===zf?"end":"middle"),w.each(function(){this.__axis=v})}return f.scale=function(d){return arguments.length?(t=d,f):t},f.ticks=function(){return n=Array.from(arguments),f},f.tickArguments=function(d){return arguments.length?(n=d==null?[]:Array.from(d),f):n.slice()},f.tickValues=function(d){return arguments.length?(i=d==null?null:Array.from(d),f):i&&i.slice()},f.tickFormat=function(d){return arguments.length?(r=d,f):r},f.tickSize=function(d){return arguments.length?(s=o=+d,f):s},f.tickSizeInner=function(d){return arguments.length?(s=+d,f):s},f.tickSizeOuter=function(d){return arguments.length?(o=+d,f):o},f.tickPadding=function(d){return arguments.length?(a=+d,f):a},f.offset=function(d){return arguments.length?(c=+d,f):c},f}function yb(e){return fL(mm,e)}var gm="http://www.w3.org/1999/xhtml",rs={svg:"http://www.w3.org/2000/svg",xhtml:gm,xlink:"http://www.w3.org/1999/xlink",xml:"http://www.w3.org/XML/1998/namespace",xmlns:"http://www.w3.org/2000/xmlns/"};function xb(e){var t=e+="",n=t.indexOf(":");return n>=0&&(t=e.slice(0,n))!=="xmlns"&&(e=e.slice(n+1)),rs.hasOwnProperty(t)?{space:rs[t],local:e}:e}function hL(e){return function(){var t=this.ownerDocument,n=this.namespaceURI;return n===gm&&t.documentElement.namespaceURI===gm?t.createElement(e):t.createElementNS(n,e)}}function dL(e){return function(){return this.ownerDocument.createElementNS(e.space,e.local)}}function Qo(e){var t=xb(e);return(t.local?dL:hL)(t)}function pL(){}function vb(e){return e==null?pL:function(){return this.querySelector(e)}}function mL(e){typeof e!="function"&&(e=vb(e));for(var t=this._groups,n=t.length,i=new Array(n),r=0;r<n;++r)for(var s=t[r],o=s.length,a=i[r]=new Array(o),c,l,u=0;u<o;++u)(c=s[u])&&(l=e.call(c,c.__data__,u,s))&&("__data__"in c&&(l.__data__=c.__data__),a[u]=l);return new zn(i,this._parents)}function gL(e){return e==null?[]:Array.isArray(e)?e:Array.from(e)}function _L(){return[]}function yL(e){return e==null?_L:function(){return this.querySelectorAll(e)}}function xL(e){return function(){return gL(e.apply(this,arguments))}}function vL(e){typeof e=="function"?e=xL(e):e=yL(e);for(var t=this._groups,n=t.length,i=[],r=[],s=0;s<n;++s)for(var o=t[s],a=o.length,c,l=0;l<a;++l)(c=o[l])&&(i.push(e.call(c,c.__data__,l,o)),r.push(c));return new zn(i,r)}function bL(e){return function(){return this.matches(e)}}function bb(e){return function(t){return t.matches(e)}}var ML=Array.prototype.find;function SL(e){return function(){return ML.call(this.children,e)}}function wL(){return this.firstElementChild}function TL(e){return this.select(e==null?wL:SL(typeof e=="function"?e:bb(e)))}var AL=Array.prototype.filter;function EL(){return Array.from(this.children)}function CL(e){return function(){return AL.call(this.children,e)}}function RL(e){return this.selectAll(e==null?EL:CL(typeof e=="function"?e:bb(e)))}function PL(e){typeof e!="function"&&(e=bL(e));for(var t=this._groups,n=t.length,i=new Array(n),r=0;r<n;++r)for(var s=t[r],o=s.length,a=i[r]=[],c,l=0;l<o;++l)(c=s[l])&&e.call(c,c.__data__,l,s)&&a.push(c);return new zn(i,this._parents)}function Mb(e){return new Array(e.length)}function IL(){return new zn(this._enter||this._groups.map(Mb),this._parents)}function Gf(e,t){this.ownerDocument=e.ownerDocument,this.namespaceURI=e.namespaceURI,this._next=null,this._parent=e,this.__data__=t}Gf.prototype={constructor:Gf,appendChild:function(e){return this._parent.insertBefore(e,this._next)},insertBefore:function(e,t){return this._parent.insertBefore(e,t)},querySelector:function(e){return this._parent.querySelector(e)},querySelectorAll:function(e){return this._parent.querySelectorAll(e)}};function LL(e){return function(){return e}}function NL(e,t,n,i,r,s){for(var o=0,a,c=t.length,l=s.length;o<l;++o)(a=t[o])?(a.__data__=s[o],i[o]=a):n[o]=new Gf(e,s[o]);for(;o<c;++o)(a=t[o])&&(r[o]=a)}function DL(e,t,n,i,r,s,o){var a,c,l=new Map,u=t.length,h=s.length,f=new Array(u),d;for(a=0;a<u;++a)(c=t[a])&&(f[a]=d=o.call(c,c.__data__,a,t)+"",l.has(d)?r[a]=c:l.set(d,c));for(a=0;a<h;++a)d=o.call(e,s[a],a,s)+"",(c=l.get(d))?(i[a]=c,c.__data__=s[a],l.delete(d)):n[a]=new Gf(e,s[a]);for(a=0;a<u;++a)(c=t[a])&&l.get(f[a])===c&&(r[a]=c)}function UL(e){return e.__data__}function FL(e,t){if(!arguments.length)return Array.from(this,UL);var n=t?DL:NL,i=this._parents,r=this._groups;typeof e!="function"&&(e=LL(e));for(var s=r.length,o=new Array(s),a=new Array(s),c=new Array(s),l=0;l<s;++l){var u=i[l],h=r[l],f=h.length,d=OL(e.call(u,u&&u.__data__,l,i)),p=d.length,_=a[l]=new Array(p),g=o[l]=new Array(p),m=c[l]=new Array(f);n(u,h,_,g,m,d,t);for(var x=0,S=0,v,w;x<p;++x)if(v=_[x]){for(x>=S&&(S=x+1);!(w=g[S])&&++S<p;);v._next=w||null}}return o=new zn(o,i),o._enter=a,o._exit=c,o}function OL(e){return typeof e=="object"&&"length"in e?e:Array.from(e)}function BL(){return new zn(this._exit||this._groups.map(Mb),this._parents)}function kL(e,t,n){var i=this.enter(),r=this,s=this.exit();return typeof e=="function"?(i=e(i),i&&(i=i.selection())):i=i.append(e+""),t!=null&&(r=t(r),r&&(r=r.selection())),n==null?s.remove():n(s),i&&r?i.merge(r).order():r}function zL(e){for(var t=e.selection?e.selection():e,n=this._groups,i=t._groups,r=n.length,s=i.length,o=Math.min(r,s),a=new Array(r),c=0;c<o;++c)for(var l=n[c],u=i[c],h=l.length,f=a[c]=new Array(h),d,p=0;p<h;++p)(d=l[p]||u[p])&&(f[p]=d);for(;c<r;++c)a[c]=n[c];return new zn(a,this._parents)}function GL(){for(var e=this._groups,t=-1,n=e.length;++t<n;)for(var i=e[t],r=i.length-1,s=i[r],o;--r>=0;)(o=i[r])&&(s&&o.compareDocumentPosition(s)^4&&s.parentNode.insertBefore(o,s),s=o);return this}function VL(e){e||(e=HL);function t(h,f){return h&&f?e(h.__data__,f.__data__):!h-!f}for(var n=this._groups,i=n.length,r=new Array(i),s=0;s<i;++s){for(var o=n[s],a=o.length,c=r[s]=new Array(a),l,u=0;u<a;++u)(l=o[u])&&(c[u]=l);c.sort(t)}return new zn(r,this._parents).order()}function HL(e,t){return e<t?-1:e>t?1:e>=t?0:NaN}function WL(){var e=arguments[0];return arguments[0]=this,e.apply(null,arguments),this}function $L(){return Array.from(this)}function XL(){for(var e=this._groups,t=0,n=e.length;t<n;++t)for(var i=e[t],r=0,s=i.length;r<s;++r){var o=i[r];if(o)return o}return null}function qL(){let e=0;for(let t of this)++e;return e}function YL(){return!this.node()}function ZL(e){for(var t=this._groups,n=0,i=t.length;n<i;++n)for(var r=t[n],s=0,o=r.length,a;s<o;++s)(a=r[s])&&e.call(a,a.__data__,s,r);return this}function JL(e){return function(){this.removeAttribute(e)}}function KL(e){return function(){this.removeAttributeNS(e.space,e.local)}}function jL(e,t){return function(){this.setAttribute(e,t)}}function QL(e,t){return function(){this.setAttributeNS(e.space,e.local,t)}}function tN(e,t){return function(){var n=t.apply(this,arguments);n==null?this.removeAttribute(e):this.setAttribute(e,n)}}function eN(e,t){return function(){var n=t.apply(this,arguments);n==null?this.removeAttributeNS(e.space,e.local):this.setAttributeNS(e.space,e.local,n)}}function nN(e,t){var n=xb(e);if(arguments.length<2){var i=this.node();return n.local?i.getAttributeNS(n.space,n.local):i.getAttribute(n)}return this.each((t==null?n.local?KL:JL:typeof t=="function"?n.local?eN:tN:n.local?QL:jL)(n,t))}function Sb(e){return e.ownerDocument&&e.ownerDocument.defaultView||e.document&&e||e.defaultView}function iN(e){return function(){this.style.removeProperty(e)}}function rN(e,t,n){return function(){this.style.setProperty(e,t,n)}}function sN(e,t,n){return function(){var i=t.apply(this,arguments);i==null?this.style.removeProperty(e):this.style.setProperty(e,i,n)}}function oN(e,t,n){return arguments.length>1?this.each((t==null?iN:typeof t=="function"?sN:rN)(e,t,n??"")):aN(this.node(),e)}function aN(e,t){return e.style.getPropertyValue(t)||Sb(e).getComputedStyle(e,null).getPropertyValue(t)}function cN(e){return function(){delete this[e]}}function lN(e,t){return function(){this[e]=t}}function uN(e,t){return function(){var n=t.apply(this,arguments);n==null?delete this[e]:this[e]=n}}function fN(e,t){return arguments.length>1?this.each((t==null?cN:typeof t=="function"?uN:lN)(e,t)):this.node()[e]}function wb(e){return e.trim().split(/^|\s+/)}function ym(e){return e.classList||new Tb(e)}function Tb(e){this._node=e,this._names=wb(e.getAttribute("class")||"")}Tb.prototype={add:function(e){var t=this._names.indexOf(e);t<0&&(this._names.push(e),this._node.setAttribute("class",this._names.join(" ")))},remove:function(e){var t=this._names.indexOf(e);t>=0&&(this._names.splice(t,1),this._node.setAttribute("class",this._names.join(" ")))},contains:function(e){return this._names.indexOf(e)>=0}};function Ab(e,t){for(var n=ym(e),i=-1,r=t.length;++i<r;)n.add(t[i])}function Eb(e,t){for(var n=ym(e),i=-1,r=t.length;++i<r;)n.remove(t[i])}function hN(e){return function(){Ab(this,e)}}function dN(e){return function(){Eb(this,e)}}function pN(e,t){return function(){(t.apply(this,arguments)?Ab:Eb)(this,e)}}function mN(e,t){var n=wb(e+"");if(arguments.length<2){for(var i=ym(this.node()),r=-1,s=n.length;++r<s;)if(!i.contains(n[r]))return!1;return!0}return this.each((typeof t=="function"?pN:t?hN:dN)(n,t))}function gN(){this.textContent=""}function _N(e){return function(){this.textContent=e}}function yN(e){return function(){var t=e.apply(this,arguments);this.textContent=t??""}}function xN(e){return arguments.length?this.each(e==null?gN:(typeof e=="function"?yN:_N)(e)):this.node().textContent}function vN(){this.innerHTML=""}function bN(e){return function(){this.innerHTML=e}}function MN(e){return function(){var t=e.apply(this,arguments);this.innerHTML=t??""}}function SN(e){return arguments.length?this.each(e==null?vN:(typeof e=="function"?MN:bN)(e)):this.node().innerHTML}function wN(){this.nextSibling&&this.parentNode.appendChild(this)}function TN(){return this.each(wN)}function AN(){this.previousSibling&&this.parentNode.insertBefore(this,this.parentNode.firstChild)}function EN(){return this.each(AN)}function CN(e){var t=typeof e=="function"?e:Qo(e);return this.select(function(){return this.appendChild(t.apply(this,arguments))})}function RN(){return null}function PN(e,t){var n=typeof e=="function"?e:Qo(e),i=t==null?RN:typeof t=="function"?t:vb(t);return this.select(function(){return this.insertBefore(n.apply(this,arguments),i.apply(this,arguments)||null)})}function IN(){var e=this.parentNode;e&&e.removeChild(this)}function LN(){return this.each(IN)}function NN(){var e=this.cloneNode(!1),t=this.parentNode;return t?t.insertBefore(e,this.nextSibling):e}function DN(){var e=this.cloneNode(!0),t=this.parentNode;return t?t.insertBefore(e,this.nextSibling):e}function UN(e){return this.select(e?DN:NN)}function FN(e){return arguments.length?this.property("__data__",e):this.node().__data__}function ON(e){return function(t){e.call(this,t,this.__data__)}}function BN(e){return e.trim().split(/^|\s+/).map(function(t){var n="",i=t.indexOf(".");return i>=0&&(n=t.slice(i+1),t=t.slice(0,i)),{type:t,name:n}})}function kN(e){return function(){var t=this.__on;if(t){for(var n=0,i=-1,r=t.length,s;n<r;++n)s=t[n],(!e.type||s.type===e.type)&&s.name===e.name?this.removeEventListener(s.type,s.listener,s.options):t[++i]=s;++i?t.length=i:delete this.__on}}}function zN(e,t,n){return function(){var i=this.__on,r,s=ON(t);if(i){for(var o=0,a=i.length;o<a;++o)if((r=i[o]).type===e.type&&r.name===e.name){this.removeEventListener(r.type,r.listener,r.options),this.addEventListener(r.type,r.listener=s,r.options=n),r.value=t;return}}this.addEventListener(e.type,s,n),r={type:e.type,name:e.name,value:t,listener:s,options:n},i?i.push(r):this.__on=[r]}}function GN(e,t,n){var i=BN(e+""),r,s=i.length,o;if(arguments.length<2){var a=this.node().__on;if(a){for(var c=0,l=a.length,u;c<l;++c)for(r=0,u=a[c];r<s;++r)if((o=i[r]).type===u.type&&o.name===u.name)return u.value}return}for(a=t?zN:kN,r=0;r<s;++r)this.each(a(i[r],t,n));return this}function Cb(e,t,n){var i=Sb(e),r=i.CustomEvent;typeof r=="function"?r=new r(t,n):(r=i.document.createEvent("Event"),n?(r.initEvent(t,n.bubbles,n.cancelable),r.detail=n.detail):r.initEvent(t,!1,!1)),e.dispatchEvent(r)}function VN(e,t){return function(){return Cb(this,e,t)}}function HN(e,t){return function(){return Cb(this,e,t.apply(this,arguments))}}function WN(e,t){return this.each((typeof t=="function"?HN:VN)(e,t))}function*$N(){for(var e=this._groups,t=0,n=e.length;t<n;++t)for(var i=e[t],r=0,s=i.length,o;r<s;++r)(o=i[r])&&(yield o)}var Rb=[null];function zn(e,t){this._groups=e,this._parents=t}function XN(){return new zn([[document.documentElement]],Rb)}function qN(){return this}zn.prototype=XN.prototype={constructor:zn,select:mL,selectAll:vL,selectChild:TL,selectChildren:RL,filter:PL,data:FL,enter:IL,exit:BL,join:kL,merge:zL,selection:qN,order:GL,sort:VL,call:WL,nodes:$L,node:XL,size:qL,empty:YL,each:ZL,attr:nN,style:oN,property:fN,classed:mN,text:xN,html:SN,raise:TN,lower:EN,append:CN,insert:PN,remove:LN,clone:UN,datum:FN,on:GN,dispatch:WN,[Symbol.iterator]:$N};function Ti(e){return typeof e=="string"?new zn([[document.querySelector(e)]],[document.documentElement]):new zn([[e]],Rb)}var YN=0;function ZN(){return new _m}function _m(){this._="@"+(++YN).toString(36)}_m.prototype=ZN.prototype={constructor:_m,get:function(e){for(var t=this._;!(t in e);)if(!(e=e.parentNode))return;return e[t]},set:function(e,t){return e[this._]=t},remove:function(e){return this._ in e&&delete e[this._]},toString:function(){return this._}};function JN(e){let t;for(;t=e.sourceEvent;)e=t;return e}function Pb(e,t){if(e=JN(e),t===void 0&&(t=e.currentTarget),t){var n=t.ownerSVGElement||t;if(n.createSVGPoint){var i=n.createSVGPoint();return i.x=e.clientX,i.y=e.clientY,i=i.matrixTransform(t.getScreenCTM().inverse()),[i.x,i.y]}if(t.getBoundingClientRect){var r=t.getBoundingClientRect();return[e.clientX-r.left-t.clientLeft,e.clientY-r.top-t.clientTop]}}return[e.pageX,e.pageY]}function ia(e,t,n){e.prototype=t.prototype=n,n.constructor=e}function Bc(e,t){var n=Object.create(e.prototype);for(var i in t)n[i]=t[i];return n}function ss(){}var ks=.7,na=1/ks,ta="\\s*([+-]?\\d+)\\s*",Fc="\\s*([+-]?(?:\\d*\\.)?\\d+(?:[eE][+-]?\\d+)?)\\s*",Gi="\\s*([+-]?(?:\\d*\\.)?\\d+(?:[eE][+-]?\\d+)?)%\\s*",KN=/^#([0-9a-f]{3,8})$/,jN=new RegExp(`^rgb\\(${ta},${ta},${ta}\\)$`),QN=new RegExp(`^rgb\\(${Gi},${Gi},${Gi}\\)$`),tD=new RegExp(`^rgba\\(${ta},${ta},${ta},${Fc}\\)$`),eD=new RegExp(`^rgba\\(${Gi},${Gi},${Gi},${Fc}\\)$`),nD=new RegExp(`^hsl\\(${Fc},${Gi},${Gi}\\)$`),iD=new RegExp(`^hsla\\(${Fc},${Gi},${Gi},${Fc}\\)$`),Ib={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074};ia(ss,ra,{copy(e){return Object.assign(new this.constructor,this,e)},displayable(){return this.rgb().displayable()},hex:Lb,formatHex:Lb,formatHex8:rD,formatHsl:sD,formatRgb:Nb,toString:Nb});function Lb(){return this.rgb().formatHex()}function rD(){return this.rgb().formatHex8()}function sD(){return Vb(this).formatHsl()}function Nb(){return this.rgb().formatRgb()}function ra(e){var t,n;return e=(e+"").trim().toLowerCase(),(t=KN.exec(e))?(n=t[1].length,t=parseInt(t[1],16),n===6?Db(t):n===3?new Ze(t>>8&15|t>>4&240,t>>4&15|t&240,(t&15)<<4|t&15,1):n===8?Vf(t>>24&255,t>>16&255,t>>8&255,(t&255)/255):n===4?Vf(t>>12&15|t>>8&240,t>>8&15|t>>4&240,t>>4&15|t&240,((t&15)<<4|t&15)/255):null):(t=jN.exec(e))?new Ze(t[1],t[2],t[3],1):(t=QN.exec(e))?new Ze(t[1]*255/100,t[2]*255/100,t[3]*255/100,1):(t=tD.exec(e))?Vf(t[1],t[2],t[3],t[4]):(t=eD.exec(e))?Vf(t[1]*255/100,t[2]*255/100,t[3]*255/100,t[4]):(t=nD.exec(e))?Ob(t[1],t[2]/100,t[3]/100,1):(t=iD.exec(e))?Ob(t[1],t[2]/100,t[3]/100,t[4]):Ib.hasOwnProperty(e)?Db(Ib[e]):e==="transparent"?new Ze(NaN,NaN,NaN,0):null}function Db(e){return new Ze(e>>16&255,e>>8&255,e&255,1)}function Vf(e,t,n,i){return i<=0&&(e=t=n=NaN),new Ze(e,t,n,i)}function wm(e){return e instanceof ss||(e=ra(e)),e?(e=e.rgb(),new Ze(e.r,e.g,e.b,e.opacity)):new Ze}function Ei(e,t,n,i){return arguments.length===1?wm(e):new Ze(e,t,n,i??1)}function Ze(e,t,n,i){this.r=+e,this.g=+t,this.b=+n,this.opacity=+i}ia(Ze,Ei,Bc(ss,{brighter(e){return e=e==null?na:Math.pow(na,e),new Ze(this.r*e,this.g*e,this.b*e,this.opacity)},darker(e){return e=e==null?ks:Math.pow(ks,e),new Ze(this.r*e,this.g*e,this.b*e,this.opacity)},rgb(){return this},clamp(){return new Ze(Os(this.r),Os(this.g),Os(this.b),Wf(this.opacity))},displayable(){return-.5<=this.r&&this.r<255.5&&-.5<=this.g&&this.g<255.5&&-.5<=this.b&&this.b<255.5&&0<=this.opacity&&this.opacity<=1},hex:Ub,formatHex:Ub,formatHex8:oD,formatRgb:Fb,toString:Fb}));function Ub(){return`#${Fs(this.r)}${Fs(this.g)}${Fs(this.b)}`}function oD(){return`#${Fs(this.r)}${Fs(this.g)}${Fs(this.b)}${Fs((isNaN(this.opacity)?1:this.opacity)*255)}`}function Fb(){let e=Wf(this.opacity);return`${e===1?"rgb(":"rgba("}${Os(this.r)}, ${Os(this.g)}, ${Os(this.b)}${e===1?")":`, ${e})`}`}function Wf(e){return isNaN(e)?1:Math.max(0,Math.min(1,e))}function Os(e){return Math.max(0,Math.min(255,Math.round(e)||0))}function Fs(e){return e=Os(e),(e<16?"0":"")+e.toString(16)}function Ob(e,t,n,i){return i<=0?e=t=n=NaN:n<=0||n>=1?e=t=NaN:t<=0&&(e=NaN),new Ai(e,t,n,i)}function Vb(e){if(e instanceof Ai)return new Ai(e.h,e.s,e.l,e.opacity);if(e instanceof ss||(e=ra(e)),!e)return new Ai;if(e instanceof Ai)return e;e=e.rgb();var t=e.r/255,n=e.g/255,i=e.b/255,r=Math.min(t,n,i),s=Math.max(t,n,i),o=NaN,a=s-r,c=(s+r)/2;return a?(t===s?o=(n-i)/a+(n<i)*6:n===s?o=(i-t)/a+2:o=(t-n)/a+4,a/=c<.5?s+r:2-s-r,o*=60):a=c>0&&c<1?0:o,new Ai(o,a,c,e.opacity)}function Xf(e,t,n,i){return arguments.length===1?Vb(e):new Ai(e,t,n,i??1)}function Ai(e,t,n,i){this.h=+e,this.s=+t,this.l=+n,this.opacity=+i}ia(Ai,Xf,Bc(ss,{brighter(e){return e=e==null?na:Math.pow(na,e),new Ai(this.h,this.s,this.l*e,this.opacity)},darker(e){return e=e==null?ks:Math.pow(ks,e),new Ai(this.h,this.s,this.l*e,this.opacity)},rgb(){var e=this.h%360+(this.h<0)*360,t=isNaN(e)||isNaN(this.s)?0:this.s,n=this.l,i=n+(n<.5?n:1-n)*t,r=2*n-i;return new Ze(xm(e>=240?e-240:e+120,r,i),xm(e,r,i),xm(e<120?e+240:e-120,r,i),this.opacity)},clamp(){return new Ai(Bb(this.h),Hf(this.s),Hf(this.l),Wf(this.opacity))},displayable(){return(0<=this.s&&this.s<=1||isNaN(this.s))&&0<=this.l&&this.l<=1&&0<=this.opacity&&this.opacity<=1},formatHsl(){let e=Wf(this.opacity);return`${e===1?"hsl(":"hsla("}${Bb(this.h)}, ${Hf(this.s)*100}%, ${Hf(this.l)*100}%${e===1?")":`, ${e})`}`}}));function Bb(e){return e=(e||0)%360,e<0?e+360:e}function Hf(e){return Math.max(0,Math.min(1,e||0))}function xm(e,t,n){return(e<60?t+(n-t)*e/60:e<180?n:e<240?t+(n-t)*(240-e)/60:t)*255}var Hb=Math.PI/180,Wb=180/Math.PI,$f=18,$b=.96422,Xb=1,qb=.82521,Yb=4/29,ea=6/29,Zb=3*ea*ea,aD=ea*ea*ea;function Jb(e){if(e instanceof Vi)return new Vi(e.l,e.a,e.b,e.opacity);if(e instanceof Mr)return Kb(e);e instanceof Ze||(e=wm(e));var t=Sm(e.r),n=Sm(e.g),i=Sm(e.b),r=vm((.2225045*t+.7168786*n+.0606169*i)/Xb),s,o;return t===n&&n===i?s=o=r:(s=vm((.4360747*t+.3850649*n+.1430804*i)/$b),o=vm((.0139322*t+.0971045*n+.7141733*i)/qb)),new Vi(116*r-16,500*(s-r),200*(r-o),e.opacity)}function qf(e,t,n,i){return arguments.length===1?Jb(e):new Vi(e,t,n,i??1)}function Vi(e,t,n,i){this.l=+e,this.a=+t,this.b=+n,this.opacity=+i}ia(Vi,qf,Bc(ss,{brighter(e){return new Vi(this.l+$f*(e??1),this.a,this.b,this.opacity)},darker(e){return new Vi(this.l-$f*(e??1),this.a,this.b,this.opacity)},rgb(){var e=(this.l+16)/116,t=isNaN(this.a)?e:e+this.a/500,n=isNaN(this.b)?e:e-this.b/200;return t=$b*bm(t),e=Xb*bm(e),n=qb*bm(n),new Ze(Mm(3.1338561*t-1.6168667*e-.4906146*n),Mm(-.9787684*t+1.9161415*e+.033454*n),Mm(.0719453*t-.2289914*e+1.4052427*n),this.opacity)}}));function vm(e){return e>aD?Math.pow(e,1/3):e/Zb+Yb}function bm(e){return e>ea?e*e*e:Zb*(e-Yb)}function Mm(e){return 255*(e<=.0031308?12.92*e:1.055*Math.pow(e,1/2.4)-.055)}function Sm(e){return(e/=255)<=.04045?e/12.92:Math.pow((e+.055)/1.055,2.4)}function cD(e){if(e instanceof Mr)return new Mr(e.h,e.c,e.l,e.opacity);if(e instanceof Vi||(e=Jb(e)),e.a===0&&e.b===0)return new Mr(NaN,0<e.l&&e.l<100?0:NaN,e.l,e.opacity);var t=Math.atan2(e.b,e.a)*Wb;return new Mr(t<0?t+360:t,Math.sqrt(e.a*e.a+e.b*e.b),e.l,e.opacity)}function Yf(e,t,n,i){return arguments.length===1?cD(e):new Mr(e,t,n,i??1)}function Mr(e,t,n,i){this.h=+e,this.c=+t,this.l=+n,this.opacity=+i}function Kb(e){if(isNaN(e.h))return new Vi(e.l,0,0,e.opacity);var t=e.h*Hb;return new Vi(e.l,Math.cos(t)*e.c,Math.sin(t)*e.c,e.opacity)}ia(Mr,Yf,Bc(ss,{brighter(e){return new Mr(this.h,this.c,this.l+$f*(e??1),this.opacity)},darker(e){return new Mr(this.h,this.c,this.l-$f*(e??1),this.opacity)},rgb(){return Kb(this).rgb()}}));var jb=-.14861,Tm=1.78277,Am=-.29227,Zf=-.90649,Oc=1.97294,kb=Oc*Zf,zb=Oc*Tm,Gb=Tm*Am-Zf*jb;function lD(e){if(e instanceof Bs)return new Bs(e.h,e.s,e.l,e.opacity);e instanceof Ze||(e=wm(e));var t=e.r/255,n=e.g/255,i=e.b/255,r=(Gb*i+kb*t-zb*n)/(Gb+kb-zb),s=i-r,o=(Oc*(n-r)-Am*s)/Zf,a=Math.sqrt(o*o+s*s)/(Oc*r*(1-r)),c=a?Math.atan2(o,s)*Wb-120:NaN;return new Bs(c<0?c+360:c,a,r,e.opacity)}function ii(e,t,n,i){return arguments.length===1?lD(e):new Bs(e,t,n,i??1)}function Bs(e,t,n,i){this.h=+e,this.s=+t,this.l=+n,this.opacity=+i}ia(Bs,ii,Bc(ss,{brighter(e){return e=e==null?na:Math.pow(na,e),new Bs(this.h,this.s,this.l*e,this.opacity)},darker(e){return e=e==null?ks:Math.pow(ks,e),new Bs(this.h,this.s,this.l*e,this.opacity)},rgb(){var e=isNaN(this.h)?0:(this.h+120)*Hb,t=+this.l,n=isNaN(this.s)?0:this.s*t*(1-t),i=Math.cos(e),r=Math.sin(e);return new Ze(255*(t+n*(jb*i+Tm*r)),255*(t+n*(Am*i+Zf*r)),255*(t+n*(Oc*i)),this.opacity)}}));function e1(e,t,n,i,r){var s=e*e,o=s*e;return((1-3*e+3*s-o)*t+(4-6*s+3*o)*n+(1+3*e+3*s-3*o)*i+o*r)/6}function uD(e){var t=e.length-1;return function(n){var i=n<=0?n=0:n>=1?(n=1,t-1):Math.floor(n*t),r=e[i],s=e[i+1],o=i>0?e[i-1]:2*r-s,a=i<t-1?e[i+2]:2*s-r;return e1((n-i/t)*t,o,r,s,a)}}function fD(e){var t=e.length;return function(n){var i=Math.floor(((n%=1)<0?++n:n)*t),r=e[(i+t-1)%t],s=e[i%t],o=e[(i+1)%t],a=e[(i+2)%t];return e1((n-i/t)*t,r,s,o,a)}}var Kf=e=>()=>e;function n1(e,t){return function(n){return e+n*t}}function hD(e,t,n){return e=Math.pow(e,n),t=Math.pow(t,n)-e,n=1/n,function(i){return Math.pow(e+i*t,n)}}function Pm(e,t){var n=t-e;return n?n1(e,n>180||n<-180?n-360*Math.round(n/360):n):Kf(isNaN(e)?t:e)}function dD(e){return(e=+e)==1?Je:function(t,n){return n-t?hD(t,n,e):Kf(isNaN(t)?n:t)}}function Je(e,t){var n=t-e;return n?n1(e,n):Kf(isNaN(e)?t:e)}var zs=(function e(t){var n=dD(t);function i(r,s){var o=n((r=Ei(r)).r,(s=Ei(s)).r),a=n(r.g,s.g),c=n(r.b,s.b),l=Je(r.opacity,s.opacity);return function(u){return r.r=o(u),r.g=a(u),r.b=c(u),r.opacity=l(u),r+""}}return i.gamma=e,i})(1);function i1(e){return function(t){var n=t.length,i=new Array(n),r=new Array(n),s=new Array(n),o,a;for(o=0;o<n;++o)a=Ei(t[o]),i[o]=a.r||0,r[o]=a.g||0,s[o]=a.b||0;return i=e(i),r=e(r),s=e(s),a.opacity=1,function(c){return a.r=i(c),a.g=r(c),a.b=s(c),a+""}}}var r1=i1(uD),zk=i1(fD);function pD(e,t){t||(t=[]);var n=e?Math.min(t.length,e.length):0,i=t.slice(),r;return function(s){for(r=0;r<n;++r)i[r]=e[r]*(1-s)+t[r]*s;return i}}function mD(e){return ArrayBuffer.isView(e)&&!(e instanceof DataView)}function gD(e,t){var n=t?t.length:0,i=e?Math.min(n,e.length):0,r=new Array(i),s=new Array(n),o;for(o=0;o<i;++o)r[o]=sa(e[o],t[o]);for(;o<n;++o)s[o]=t[o];return function(a){for(o=0;o<i;++o)s[o]=r[o](a);return s}}function _D(e,t){var n=new Date;return e=+e,t=+t,function(i){return n.setTime(e*(1-i)+t*i),n}}function ke(e,t){return e=+e,t=+t,function(n){return e*(1-n)+t*n}}function yD(e,t){var n={},i={},r;(e===null||typeof e!="object")&&(e={}),(t===null||typeof t!="object")&&(t={});for(r in t)r in e?n[r]=sa(e[r],t[r]):i[r]=t[r];return function(s){for(r in n)i[r]=n[r](s);return i}}var Cm=/[-+]?(?:\d+\.?\d*|\.?\d+)(?:[eE][-+]?\d+)?/g,Em=new RegExp(Cm.source,"g");function xD(e){return function(){return e}}function vD(e){return function(t){return e(t)+""}}function bD(e,t){var n=Cm.lastIndex=Em.lastIndex=0,i,r,s,o=-1,a=[],c=[];for(e=e+"",t=t+"";(i=Cm.exec(e))&&(r=Em.exec(t));)(s=r.index)>n&&(s=t.slice(n,s),a[o]?a[o]+=s:a[++o]=s),(i=i[0])===(r=r[0])?a[o]?a[o]+=r:a[++o]=r:(a[++o]=null,c.push({i:o,x:ke(i,r)})),n=Em.lastIndex;return n<t.length&&(s=t.slice(n),a[o]?a[o]+=s:a[++o]=s),a.length<2?c[0]?vD(c[0].x):xD(t):(t=c.length,function(l){for(var u=0,h;u<t;++u)a[(h=c[u]).i]=h.x(l);return a.join("")})}function sa(e,t){var n=typeof t,i;return t==null||n==="boolean"?Kf(t):(n==="number"?ke:n==="string"?(i=ra(t))?(t=i,zs):bD:t instanceof ra?zs:t instanceof Date?_D:mD(t)?pD:Array.isArray(t)?gD:typeof t.valueOf!="function"&&typeof t.toString!="function"||isNaN(t)?yD:ke)(e,t)}function kc(e,t){return e=+e,t=+t,function(n){return Math.round(e*(1-n)+t*n)}}var Qb=180/Math.PI,Rm={translateX:0,translateY:0,rotate:0,skewX:0,scaleX:1,scaleY:1};function s1(e,t,n,i,r,s){var o,a,c;return(o=Math.sqrt(e*e+t*t))&&(e/=o,t/=o),(c=e*n+t*i)&&(n-=e*c,i-=t*c),(a=Math.sqrt(n*n+i*i))&&(n/=a,i/=a,c/=a),e*i<t*n&&(e=-e,t=-t,c=-c,o=-o),{translateX:r,translateY:s,rotate:Math.atan2(t,e)*Qb,skewX:Math.atan(c)*Qb,scaleX:o,scaleY:a}}var Jf;function MD(e){let t=new(typeof DOMMatrix=="function"?DOMMatrix:WebKitCSSMatrix)(e+"");return t.isIdentity?Rm:s1(t.a,t.b,t.c,t.d,t.e,t.f)}function SD(e){return e==null||(Jf||(Jf=document.createElementNS("http://www.w3.org/2000/svg","g")),Jf.setAttribute("transform",e),!(e=Jf.transform.baseVal.consolidate()))?Rm:(e=e.matrix,s1(e.a,e.b,e.c,e.d,e.e,e.f))}function o1(e,t,n,i){function r(l){return l.length?l.pop()+" ":""}function s(l,u,h,f,d,p){if(l!==h||u!==f){var _=d.push("translate(",null,t,null,n);p.push({i:_-4,x:ke(l,h)},{i:_-2,x:ke(u,f)})}else(h||f)&&d.push("translate("+h+t+f+n)}function o(l,u,h,f){l!==u?(l-u>180?u+=360:u-l>180&&(l+=360),f.push({i:h.push(r(h)+"rotate(",null,i)-2,x:ke(l,u)})):u&&h.push(r(h)+"rotate("+u+i)}function a(l,u,h,f){l!==u?f.push({i:h.push(r(h)+"skewX(",null,i)-2,x:ke(l,u)}):u&&h.push(r(h)+"skewX("+u+i)}function c(l,u,h,f,d,p){if(l!==h||u!==f){var _=d.push(r(d)+"scale(",null,",",null,")");p.push({i:_-4,x:ke(l,h)},{i:_-2,x:ke(u,f)})}else(h!==1||f!==1)&&d.push(r(d)+"scale("+h+","+f+")")}return function(l,u){var h=[],f=[];return l=e(l),u=e(u),s(l.translateX,l.translateY,u.translateX,u.translateY,h,f),o(l.rotate,u.rotate,h,f),a(l.skewX,u.skewX,h,f),c(l.scaleX,l.scaleY,u.scaleX,u.scaleY,h,f),l=u=null,function(d){for(var p=-1,_=f.length,g;++p<_;)h[(g=f[p]).i]=g.x(d);return h.join("")}}}var Gk=o1(MD,"px, ","px)","deg)"),Vk=o1(SD,", ",")",")"),wD=1e-12;function t1(e){return((e=Math.exp(e))+1/e)/2}function TD(e){return((e=Math.exp(e))-1/e)/2}function AD(e){return((e=Math.exp(2*e))-1)/(e+1)}var Hk=(function e(t,n,i){function r(s,o){var a=s[0],c=s[1],l=s[2],u=o[0],h=o[1],f=o[2],d=u-a,p=h-c,_=d*d+p*p,g,m;if(_<wD)m=Math.log(f/l)/t,g=function(y){return[a+y*d,c+y*p,l*Math.exp(t*y*m)]};else{var x=Math.sqrt(_),S=(f*f-l*l+i*_)/(2*l*n*x),v=(f*f-l*l-i*_)/(2*f*n*x),w=Math.log(Math.sqrt(S*S+1)-S),b=Math.log(Math.sqrt(v*v+1)-v);m=(b-w)/t,g=function(y){var M=y*m,R=t1(w),C=l/(n*x)*(R*AD(t*M+w)-TD(w));return[a+C*d,c+C*p,l*R/t1(t*M+w)]}}return g.duration=Math.abs(m)*1e3*t/Math.SQRT2,g}return r.rho=function(s){var o=Math.max(.001,+s),a=o*o,c=a*a;return e(o,a,c)},r})(Math.SQRT2,2,4);function a1(e){return function(t,n){var i=e((t=Xf(t)).h,(n=Xf(n)).h),r=Je(t.s,n.s),s=Je(t.l,n.l),o=Je(t.opacity,n.opacity);return function(a){return t.h=i(a),t.s=r(a),t.l=s(a),t.opacity=o(a),t+""}}}var c1=a1(Pm),Wk=a1(Je);function l1(e,t){var n=Je((e=qf(e)).l,(t=qf(t)).l),i=Je(e.a,t.a),r=Je(e.b,t.b),s=Je(e.opacity,t.opacity);return function(o){return e.l=n(o),e.a=i(o),e.b=r(o),e.opacity=s(o),e+""}}function u1(e){return function(t,n){var i=e((t=Yf(t)).h,(n=Yf(n)).h),r=Je(t.c,n.c),s=Je(t.l,n.l),o=Je(t.opacity,n.opacity);return function(a){return t.h=i(a),t.c=r(a),t.l=s(a),t.opacity=o(a),t+""}}}var f1=u1(Pm),$k=u1(Je);function h1(e){return(function t(n){n=+n;function i(r,s){var o=e((r=ii(r)).h,(s=ii(s)).h),a=Je(r.s,s.s),c=Je(r.l,s.l),l=Je(r.opacity,s.opacity);return function(u){return r.h=o(u),r.s=a(u),r.l=c(Math.pow(u,n)),r.opacity=l(u),r+""}}return i.gamma=t,i})(1)}var Xk=h1(Pm),jf=h1(Je);function os(e,t){t===void 0&&(t=e,e=sa);for(var n=0,i=t.length-1,r=t[0],s=new Array(i<0?0:i);n<i;)s[n]=e(r,r=t[++n]);return function(o){var a=Math.max(0,Math.min(i-1,Math.floor(o*=i)));return s[a](o-a)}}function Mn(e,t){for(var n=new Array(t),i=0;i<t;++i)n[i]=e(i/(t-1));return n}var zc=Math.PI,Im=2*zc,Gs=1e-6,ED=Im-Gs;function d1(e){this._+=e[0];for(let t=1,n=e.length;t<n;++t)this._+=arguments[t]+e[t]}function CD(e){let t=Math.floor(e);if(!(t>=0))throw new Error(`invalid digits: ${e}`);if(t>15)return d1;let n=10**t;return function(i){this._+=i[0];for(let r=1,s=i.length;r<s;++r)this._+=Math.round(arguments[r]*n)/n+i[r]}}function p1(e,t,n,i){return e===n&&t===i}function RD(e){let t=Math.floor(e);if(!(t<=15))return p1;let n=10**t,i=function(r){return Math.round(r*n)};return function(r,s,o,a){return i(r)===i(o)&&i(s)===i(a)}}var Vs=class{constructor(t){this._x0=this._y0=this._x1=this._y1=null,this._="",this._append=t==null?d1:CD(t),this._equal=t==null?p1:RD(t)}moveTo(t,n){this._append`M${this._x0=this._x1=+t},${this._y0=this._y1=+n}`}closePath(){this._x1!==null&&(this._x1=this._x0,this._y1=this._y0,this._append`Z`)}lineTo(t,n){this._append`L${this._x1=+t},${this._y1=+n}`}quadraticCurveTo(t,n,i,r){this._append`Q${+t},${+n},${this._x1=+i},${this._y1=+r}`}bezierCurveTo(t,n,i,r,s,o){this._append`C${+t},${+n},${+i},${+r},${this._x1=+s},${this._y1=+o}`}arcTo(t,n,i,r,s){if(t=+t,n=+n,i=+i,r=+r,s=+s,s<0)throw new Error(`negative radius: ${s}`);let o=this._x1,a=this._y1,c=i-t,l=r-n,u=o-t,h=a-n,f=u*u+h*h;if(this._x1===null)this._append`M${this._x1=t},${this._y1=n}`;else if(f>Gs)if(!(Math.abs(h*c-l*u)>Gs)||!s)this._append`L${this._x1=t},${this._y1=n}`;else{let d=i-o,p=r-a,_=c*c+l*l,g=d*d+p*p,m=Math.sqrt(_),x=Math.sqrt(f),S=s*Math.tan((zc-Math.acos((_+f-g)/(2*m*x)))/2),v=S/x,w=S/m;Math.abs(v-1)>Gs&&this._append`L${t+v*u},${n+v*h}`,this._append`A${s},${s},0,0,${+(h*d>u*p)},${this._x1=t+w*c},${this._y1=n+w*l}`}}arc(t,n,i,r,s,o){if(t=+t,n=+n,i=+i,o=!!o,i<0)throw new Error(`negative radius: ${i}`);let a=i*Math.cos(r),c=i*Math.sin(r),l=t+a,u=n+c,h=1^o,f=o?r-s:s-r;if(this._x1===null?this._append`M${l},${u}`:(Math.abs(this._x1-l)>Gs||Math.abs(this._y1-u)>Gs)&&this._append`L${l},${u}`,!!i){if(f<0&&(f=f%Im+Im),f>ED)this._append`A${i},${i},0,1,${h},${t-a},${n-c}A${i},${i},0,1,${h},${this._x1=l},${this._y1=u}`;else if(f>Gs){let d=t+i*Math.cos(s),p=n+i*Math.sin(s);if(f>=zc&&this._equal(l,u,d,p)){f/=2;let _=r+f;this._append`A${i},${i},0,${+(f>=zc)},${h},${t+i*Math.cos(_)},${n+i*Math.sin(_)}`}this._append`A${i},${i},0,${+(f>=zc)},${h},${this._x1=d},${this._y1=p}`}}}rect(t,n,i,r){this._append`M${this._x0=this._x1=+t},${this._y0=this._y1=+n}h${i=+i}v${+r}h${-i}Z`}toString(){return this._}};function PD(){return new Vs}PD.prototype=Vs.prototype;function Hi(e=3){return new Vs(+e)}function ID(e){return Math.abs(e=Math.round(e))>=1e21?e.toLocaleString("en").replace(/,/g,""):e.toString(10)}function th(e,t){if(!isFinite(e)||e===0)return null;var n=(e=t?e.toExponential(t-1):e.toExponential()).indexOf("e"),i=e.slice(0,n);return[i.length>1?i[0]+i.slice(2):i,+e.slice(n+1)]}function oa(e){return e=th(Math.abs(e)),e?e[1]:NaN}function LD(e,t){return function(n,i){for(var r=n.length,s=[],o=0,a=e[0],c=0;r>0&&a>0&&(c+a+1>i&&(a=Math.max(1,i-c)),s.push(n.substring(r-=a,r+a)),!((c+=a+1)>i));)a=e[o=(o+1)%e.length];return s.reverse().join(t)}}function ND(e){return function(t){return t.replace(/[0-9]/g,function(n){return e[+n]})}}var DD=/^(?:(.)?([<>=^]))?([+\-( ])?([$#])?(0)?(\d+)?(,)?(\.\d+)?(~)?([a-z%])?$/i;function aa(e){if(!(t=DD.exec(e)))throw new Error("invalid format: "+e);var t;return new Lm({fill:t[1],align:t[2],sign:t[3],symbol:t[4],zero:t[5],width:t[6],comma:t[7],precision:t[8]&&t[8].slice(1),trim:t[9],type:t[10]})}aa.prototype=Lm.prototype;function Lm(e){this.fill=e.fill===void 0?" ":e.fill+"",this.align=e.align===void 0?">":e.align+"",this.sign=e.sign===void 0?"-":e.sign+"",this.symbol=e.symbol===void 0?"":e.symbol+"",this.zero=!!e.zero,this.width=e.width===void 0?void 0:+e.width,this.comma=!!e.comma,this.precision=e.precision===void 0?void 0:+e.precision,this.trim=!!e.trim,this.type=e.type===void 0?"":e.type+""}Lm.prototype.toString=function(){return this.fill+this.align+this.sign+this.symbol+(this.zero?"0":"")+(this.width===void 0?"":Math.max(1,this.width|0))+(this.comma?",":"")+(this.precision===void 0?"":"."+Math.max(0,this.precision|0))+(this.trim?"~":"")+this.type};function UD(e){t:for(var t=e.length,n=1,i=-1,r;n<t;++n)switch(e[n]){case".":i=r=n;break;case"0":i===0&&(i=n),r=n;break;default:if(!+e[n])break t;i>0&&(i=0);break}return i>0?e.slice(0,i)+e.slice(r+1):e}var eh;function FD(e,t){var n=th(e,t);if(!n)return eh=void 0,e.toPrecision(t);var i=n[0],r=n[1],s=r-(eh=Math.max(-8,Math.min(8,Math.floor(r/3)))*3)+1,o=i.length;return s===o?i:s>o?i+new Array(s-o+1).join("0"):s>0?i.slice(0,s)+"."+i.slice(s):"0."+new Array(1-s).join("0")+th(e,Math.max(0,t+s-1))[0]}function m1(e,t){var n=th(e,t);if(!n)return e+"";var i=n[0],r=n[1];return r<0?"0."+new Array(-r).join("0")+i:i.length>r+1?i.slice(0,r+1)+"."+i.slice(r+1):i+new Array(r-i.length+2).join("0")}var g1={"%":(e,t)=>(e*100).toFixed(t),b:e=>Math.round(e).toString(2),c:e=>e+"",d:ID,e:(e,t)=>e.toExponential(t),f:(e,t)=>e.toFixed(t),g:(e,t)=>e.toPrecision(t),o:e=>Math.round(e).toString(8),p:(e,t)=>m1(e*100,t),r:m1,s:FD,X:e=>Math.round(e).toString(16).toUpperCase(),x:e=>Math.round(e).toString(16)};function _1(e){return e}var y1=Array.prototype.map,x1=["y","z","a","f","p","n","\xB5","m","","k","M","G","T","P","E","Z","Y"];function OD(e){var t=e.grouping===void 0||e.thousands===void 0?_1:LD(y1.call(e.grouping,Number),e.thousands+""),n=e.currency===void 0?"":e.currency[0]+"",i=e.currency===void 0?"":e.currency[1]+"",r=e.decimal===void 0?".":e.decimal+"",s=e.numerals===void 0?_1:ND(y1.call(e.numerals,String)),o=e.percent===void 0?"%":e.percent+"",a=e.minus===void 0?"\u2212":e.minus+"",c=e.nan===void 0?"NaN":e.nan+"";function l(h,f){h=aa(h);var d=h.fill,p=h.align,_=h.sign,g=h.symbol,m=h.zero,x=h.width,S=h.comma,v=h.precision,w=h.trim,b=h.type;b==="n"?(S=!0,b="g"):g1[b]||(v===void 0&&(v=12),w=!0,b="g"),(m||d==="0"&&p==="=")&&(m=!0,d="0",p="=");var y=(f&&f.prefix!==void 0?f.prefix:"")+(g==="$"?n:g==="#"&&/[boxX]/.test(b)?"0"+b.toLowerCase():""),M=(g==="$"?i:/[%p]/.test(b)?o:"")+(f&&f.suffix!==void 0?f.suffix:""),R=g1[b],C=/[defgprs%]/.test(b);v=v===void 0?6:/[gprs]/.test(b)?Math.max(1,Math.min(21,v)):Math.max(0,Math.min(20,v));function E(N){var k=y,P=M,L,B,U;if(b==="c")P=R(N)+P,N="";else{N=+N;var Z=N<0||1/N<0;if(N=isNaN(N)?c:R(Math.abs(N),v),w&&(N=UD(N)),Z&&+N==0&&_!=="+"&&(Z=!1),k=(Z?_==="("?_:a:_==="-"||_==="("?"":_)+k,P=(b==="s"&&!isNaN(N)&&eh!==void 0?x1[8+eh/3]:"")+P+(Z&&_==="("?")":""),C){for(L=-1,B=N.length;++L<B;)if(U=N.charCodeAt(L),48>U||U>57){P=(U===46?r+N.slice(L+1):N.slice(L))+P,N=N.slice(0,L);break}}}S&&!m&&(N=t(N,1/0));var F=k.length+N.length+P.length,G=F<x?new Array(x-F+1).join(d):"";switch(S&&m&&(N=t(G+N,G.length?x-P.length:1/0),G=""),p){case"<":N=k+N+P+G;break;case"=":N=k+G+N+P;break;case"^":N=G.slice(0,F=G.length>>1)+k+N+P+G.slice(F);break;default:N=G+k+N+P;break}return s(N)}return E.toString=function(){return h+""},E}function u(h,f){var d=Math.max(-8,Math.min(8,Math.floor(oa(f)/3)))*3,p=Math.pow(10,-d),_=l((h=aa(h),h.type="f",h),{suffix:x1[8+d/3]});return function(g){return _(p*g)}}return{format:l,formatPrefix:u}}var Qf,Wi,Nm;BD({thousands:",",grouping:[3],currency:["$",""]});function BD(e){return Qf=OD(e),Wi=Qf.format,Nm=Qf.formatPrefix,Qf}function v1(e){return Math.max(0,-oa(Math.abs(e)))}function b1(e,t){return Math.max(0,Math.max(-8,Math.min(8,Math.floor(oa(t)/3)))*3-oa(Math.abs(e)))}function M1(e,t){return e=Math.abs(e),t=Math.abs(t)-e,Math.max(0,oa(t)-oa(e))+1}var Ht=1e-6,G1=1e-12,Qt=Math.PI,Ee=Qt/2,S1=Qt/4,Gn=Qt*2,Sn=180/Qt,Ae=Qt/180,ue=Math.abs,fa=Math.atan,wr=Math.atan2,Jt=Math.cos;var V1=Math.exp;var ch=Math.log,Dm=Math.pow,Wt=Math.sin,si=Math.sign||function(e){return e>0?1:e<0?-1:0},Rn=Math.sqrt,tg=Math.tan;function H1(e){return e>1?0:e<-1?Qt:Math.acos(e)}function ai(e){return e>1?Ee:e<-1?-Ee:Math.asin(e)}function oi(){}function lh(e,t){e&&T1.hasOwnProperty(e.type)&&T1[e.type](e,t)}var w1={Feature:function(e,t){lh(e.geometry,t)},FeatureCollection:function(e,t){for(var n=e.features,i=-1,r=n.length;++i<r;)lh(n[i].geometry,t)}},T1={Sphere:function(e,t){t.sphere()},Point:function(e,t){e=e.coordinates,t.point(e[0],e[1],e[2])},MultiPoint:function(e,t){for(var n=e.coordinates,i=-1,r=n.length;++i<r;)e=n[i],t.point(e[0],e[1],e[2])},LineString:function(e,t){km(e.coordinates,t,0)},MultiLineString:function(e,t){for(var n=e.coordinates,i=-1,r=n.length;++i<r;)km(n[i],t,0)},Polygon:function(e,t){A1(e.coordinates,t)},MultiPolygon:function(e,t){for(var n=e.coordinates,i=-1,r=n.length;++i<r;)A1(n[i],t)},GeometryCollection:function(e,t){for(var n=e.geometries,i=-1,r=n.length;++i<r;)lh(n[i],t)}};function km(e,t,n){var i=-1,r=e.length-n,s;for(t.lineStart();++i<r;)s=e[i],t.point(s[0],s[1],s[2]);t.lineEnd()}function A1(e,t){var n=-1,i=e.length;for(t.polygonStart();++n<i;)km(e[n],t,1);t.polygonEnd()}function as(e,t){e&&w1.hasOwnProperty(e.type)?w1[e.type](e,t):lh(e,t)}var Kk=new Qn,jk=new Qn;function zm(e){return[wr(e[1],e[0]),ai(e[2])]}function la(e){var t=e[0],n=e[1],i=Jt(n);return[i*Jt(t),i*Wt(t),Wt(n)]}function nh(e,t){return e[0]*t[0]+e[1]*t[1]+e[2]*t[2]}function uh(e,t){return[e[1]*t[2]-e[2]*t[1],e[2]*t[0]-e[0]*t[2],e[0]*t[1]-e[1]*t[0]]}function Um(e,t){e[0]+=t[0],e[1]+=t[1],e[2]+=t[2]}function ih(e,t){return[e[0]*t,e[1]*t,e[2]*t]}function Gm(e){var t=Rn(e[0]*e[0]+e[1]*e[1]+e[2]*e[2]);e[0]/=t,e[1]/=t,e[2]/=t}function Vm(e,t){function n(i,r){return i=e(i,r),t(i[0],i[1])}return e.invert&&t.invert&&(n.invert=function(i,r){return i=t.invert(i,r),i&&e.invert(i[0],i[1])}),n}function Hm(e,t){return ue(e)>Qt&&(e-=Math.round(e/Gn)*Gn),[e,t]}Hm.invert=Hm;function W1(e,t,n){return(e%=Gn)?t||n?Vm(C1(e),R1(t,n)):C1(e):t||n?R1(t,n):Hm}function E1(e){return function(t,n){return t+=e,ue(t)>Qt&&(t-=Math.round(t/Gn)*Gn),[t,n]}}function C1(e){var t=E1(e);return t.invert=E1(-e),t}function R1(e,t){var n=Jt(e),i=Wt(e),r=Jt(t),s=Wt(t);function o(a,c){var l=Jt(c),u=Jt(a)*l,h=Wt(a)*l,f=Wt(c),d=f*n+u*i;return[wr(h*r-d*s,u*n-f*i),ai(d*r+h*s)]}return o.invert=function(a,c){var l=Jt(c),u=Jt(a)*l,h=Wt(a)*l,f=Wt(c),d=f*r-h*s;return[wr(h*r+f*s,u*n+d*i),ai(d*n-u*i)]},o}function kD(e){e=W1(e[0]*Ae,e[1]*Ae,e.length>2?e[2]*Ae:0);function t(n){return n=e(n[0]*Ae,n[1]*Ae),n[0]*=Sn,n[1]*=Sn,n}return t.invert=function(n){return n=e.invert(n[0]*Ae,n[1]*Ae),n[0]*=Sn,n[1]*=Sn,n},t}function zD(e,t,n,i,r,s){if(n){var o=Jt(t),a=Wt(t),c=i*n;r==null?(r=t+i*Gn,s=t-c/2):(r=P1(o,r),s=P1(o,s),(i>0?r<s:r>s)&&(r+=i*Gn));for(var l,u=r;i>0?u>s:u<s;u-=c)l=zm([o,-a*Jt(u),-a*Wt(u)]),e.point(l[0],l[1])}}function P1(e,t){t=la(t),t[0]-=e,Gm(t);var n=H1(-t[1]);return((-t[2]<0?-n:n)+Gn-Ht)%Gn}function $1(){var e=[],t;return{point:function(n,i,r){t.push([n,i,r])},lineStart:function(){e.push(t=[])},lineEnd:oi,rejoin:function(){e.length>1&&e.push(e.pop().concat(e.shift()))},result:function(){var n=e;return e=[],t=null,n}}}function ah(e,t){return ue(e[0]-t[0])<Ht&&ue(e[1]-t[1])<Ht}function rh(e,t,n,i){this.x=e,this.z=t,this.o=n,this.e=i,this.v=!1,this.n=this.p=null}function X1(e,t,n,i,r){var s=[],o=[],a,c;if(e.forEach(function(p){if(!((_=p.length-1)<=0)){var _,g=p[0],m=p[_],x;if(ah(g,m)){if(!g[2]&&!m[2]){for(r.lineStart(),a=0;a<_;++a)r.point((g=p[a])[0],g[1]);r.lineEnd();return}m[0]+=2*Ht}s.push(x=new rh(g,p,null,!0)),o.push(x.o=new rh(g,null,x,!1)),s.push(x=new rh(m,p,null,!1)),o.push(x.o=new rh(m,null,x,!0))}}),!!s.length){for(o.sort(t),I1(s),I1(o),a=0,c=o.length;a<c;++a)o[a].e=n=!n;for(var l=s[0],u,h;;){for(var f=l,d=!0;f.v;)if((f=f.n)===l)return;u=f.z,r.lineStart();do{if(f.v=f.o.v=!0,f.e){if(d)for(a=0,c=u.length;a<c;++a)r.point((h=u[a])[0],h[1]);else i(f.x,f.n.x,1,r);f=f.n}else{if(d)for(u=f.p.z,a=u.length-1;a>=0;--a)r.point((h=u[a])[0],h[1]);else i(f.x,f.p.x,-1,r);f=f.p}f=f.o,u=f.z,d=!d}while(!f.v);r.lineEnd()}}}function I1(e){if(t=e.length){for(var t,n=0,i=e[0],r;++n<t;)i.n=r=e[n],r.p=i,i=r;i.n=r=e[0],r.p=i}}function Fm(e){return ue(e[0])<=Qt?e[0]:si(e[0])*((ue(e[0])+Qt)%Gn-Qt)}function GD(e,t){var n=Fm(t),i=t[1],r=Wt(i),s=[Wt(n),-Jt(n),0],o=0,a=0,c=new Qn;r===1?i=Ee+Ht:r===-1&&(i=-Ee-Ht);for(var l=0,u=e.length;l<u;++l)if(f=(h=e[l]).length)for(var h,f,d=h[f-1],p=Fm(d),_=d[1]/2+S1,g=Wt(_),m=Jt(_),x=0;x<f;++x,p=v,g=b,m=y,d=S){var S=h[x],v=Fm(S),w=S[1]/2+S1,b=Wt(w),y=Jt(w),M=v-p,R=M>=0?1:-1,C=R*M,E=C>Qt,N=g*b;if(c.add(wr(N*R*Wt(C),m*y+N*Jt(C))),o+=E?M+R*Gn:M,E^p>=n^v>=n){var k=uh(la(d),la(S));Gm(k);var P=uh(s,k);Gm(P);var L=(E^M>=0?-1:1)*ai(P[2]);(i>L||i===L&&(k[0]||k[1]))&&(a+=E^M>=0?1:-1)}}return(o<-Ht||o<Ht&&c<-G1)^a&1}function q1(e,t,n,i){return function(r){var s=t(r),o=$1(),a=t(o),c=!1,l,u,h,f={point:d,lineStart:_,lineEnd:g,polygonStart:function(){f.point=m,f.lineStart=x,f.lineEnd=S,u=[],l=[]},polygonEnd:function(){f.point=d,f.lineStart=_,f.lineEnd=g,u=hm(u);var v=GD(l,i);u.length?(c||(r.polygonStart(),c=!0),X1(u,HD,v,n,r)):v&&(c||(r.polygonStart(),c=!0),r.lineStart(),n(null,null,1,r),r.lineEnd()),c&&(r.polygonEnd(),c=!1),u=l=null},sphere:function(){r.polygonStart(),r.lineStart(),n(null,null,1,r),r.lineEnd(),r.polygonEnd()}};function d(v,w){e(v,w)&&r.point(v,w)}function p(v,w){s.point(v,w)}function _(){f.point=p,s.lineStart()}function g(){f.point=d,s.lineEnd()}function m(v,w){h.push([v,w]),a.point(v,w)}function x(){a.lineStart(),h=[]}function S(){m(h[0][0],h[0][1]),a.lineEnd();var v=a.clean(),w=o.result(),b,y=w.length,M,R,C;if(h.pop(),l.push(h),h=null,!!y){if(v&1){if(R=w[0],(M=R.length-1)>0){for(c||(r.polygonStart(),c=!0),r.lineStart(),b=0;b<M;++b)r.point((C=R[b])[0],C[1]);r.lineEnd()}return}y>1&&v&2&&w.push(w.pop().concat(w.shift())),u.push(w.filter(VD))}}return f}}function VD(e){return e.length>1}function HD(e,t){return((e=e.x)[0]<0?e[1]-Ee-Ht:Ee-e[1])-((t=t.x)[0]<0?t[1]-Ee-Ht:Ee-t[1])}var L1=q1(function(){return!0},WD,XD,[-Qt,-Ee]);function WD(e){var t=NaN,n=NaN,i=NaN,r;return{lineStart:function(){e.lineStart(),r=1},point:function(s,o){var a=s>0?Qt:-Qt,c=ue(s-t);ue(c-Qt)<Ht?(e.point(t,n=(n+o)/2>0?Ee:-Ee),e.point(i,n),e.lineEnd(),e.lineStart(),e.point(a,n),e.point(s,n),r=0):i!==a&&c>=Qt&&(ue(t-i)<Ht&&(t-=i*Ht),ue(s-a)<Ht&&(s-=a*Ht),n=$D(t,n,s,o),e.point(i,n),e.lineEnd(),e.lineStart(),e.point(a,n),r=0),e.point(t=s,n=o),i=a},lineEnd:function(){e.lineEnd(),t=n=NaN},clean:function(){return 2-r}}}function $D(e,t,n,i){var r,s,o=Wt(e-n);return ue(o)>Ht?fa((Wt(t)*(s=Jt(i))*Wt(n)-Wt(i)*(r=Jt(t))*Wt(e))/(r*s*o)):(t+i)/2}function XD(e,t,n,i){var r;if(e==null)r=n*Ee,i.point(-Qt,r),i.point(0,r),i.point(Qt,r),i.point(Qt,0),i.point(Qt,-r),i.point(0,-r),i.point(-Qt,-r),i.point(-Qt,0),i.point(-Qt,r);else if(ue(e[0]-t[0])>Ht){var s=e[0]<t[0]?Qt:-Qt;r=n*s/2,i.point(-s,r),i.point(0,r),i.point(s,r)}else i.point(t[0],t[1])}function qD(e){var t=Jt(e),n=2*Ae,i=t>0,r=ue(t)>Ht;function s(u,h,f,d){zD(d,e,n,f,u,h)}function o(u,h){return Jt(u)*Jt(h)>t}function a(u){var h,f,d,p,_;return{lineStart:function(){p=d=!1,_=1},point:function(g,m){var x=[g,m],S,v=o(g,m),w=i?v?0:l(g,m):v?l(g+(g<0?Qt:-Qt),m):0;if(!h&&(p=d=v)&&u.lineStart(),v!==d&&(S=c(h,x),(!S||ah(h,S)||ah(x,S))&&(x[2]=1)),v!==d)_=0,v?(u.lineStart(),S=c(x,h),u.point(S[0],S[1])):(S=c(h,x),u.point(S[0],S[1],2),u.lineEnd()),h=S;else if(r&&h&&i^v){var b;!(w&f)&&(b=c(x,h,!0))&&(_=0,i?(u.lineStart(),u.point(b[0][0],b[0][1]),u.point(b[1][0],b[1][1]),u.lineEnd()):(u.point(b[1][0],b[1][1]),u.lineEnd(),u.lineStart(),u.point(b[0][0],b[0][1],3)))}v&&(!h||!ah(h,x))&&u.point(x[0],x[1]),h=x,d=v,f=w},lineEnd:function(){d&&u.lineEnd(),h=null},clean:function(){return _|(p&&d)<<1}}}function c(u,h,f){var d=la(u),p=la(h),_=[1,0,0],g=uh(d,p),m=nh(g,g),x=g[0],S=m-x*x;if(!S)return!f&&u;var v=t*m/S,w=-t*x/S,b=uh(_,g),y=ih(_,v),M=ih(g,w);Um(y,M);var R=b,C=nh(y,R),E=nh(R,R),N=C*C-E*(nh(y,y)-1);if(!(N<0)){var k=Rn(N),P=ih(R,(-C-k)/E);if(Um(P,y),P=zm(P),!f)return P;var L=u[0],B=h[0],U=u[1],Z=h[1],F;B<L&&(F=L,L=B,B=F);var G=B-L,q=ue(G-Qt)<Ht,rt=q||G<Ht;if(!q&&Z<U&&(F=U,U=Z,Z=F),rt?q?U+Z>0^P[1]<(ue(P[0]-L)<Ht?U:Z):U<=P[1]&&P[1]<=Z:G>Qt^(L<=P[0]&&P[0]<=B)){var ct=ih(R,(-C+k)/E);return Um(ct,y),[P,zm(ct)]}}}function l(u,h){var f=i?e:Qt-e,d=0;return u<-f?d|=1:u>f&&(d|=2),h<-f?d|=4:h>f&&(d|=8),d}return q1(o,a,s,i?[0,-e]:[-Qt,e-Qt])}function YD(e,t,n,i,r,s){var o=e[0],a=e[1],c=t[0],l=t[1],u=0,h=1,f=c-o,d=l-a,p;if(p=n-o,!(!f&&p>0)){if(p/=f,f<0){if(p<u)return;p<h&&(h=p)}else if(f>0){if(p>h)return;p>u&&(u=p)}if(p=r-o,!(!f&&p<0)){if(p/=f,f<0){if(p>h)return;p>u&&(u=p)}else if(f>0){if(p<u)return;p<h&&(h=p)}if(p=i-a,!(!d&&p>0)){if(p/=d,d<0){if(p<u)return;p<h&&(h=p)}else if(d>0){if(p>h)return;p>u&&(u=p)}if(p=s-a,!(!d&&p<0)){if(p/=d,d<0){if(p>h)return;p>u&&(u=p)}else if(d>0){if(p<u)return;p<h&&(h=p)}return u>0&&(e[0]=o+u*f,e[1]=a+u*d),h<1&&(t[0]=o+h*f,t[1]=a+h*d),!0}}}}}var Gc=1e9,sh=-Gc;function eg(e,t,n,i){function r(l,u){return e<=l&&l<=n&&t<=u&&u<=i}function s(l,u,h,f){var d=0,p=0;if(l==null||(d=o(l,h))!==(p=o(u,h))||c(l,u)<0^h>0)do f.point(d===0||d===3?e:n,d>1?i:t);while((d=(d+h+4)%4)!==p);else f.point(u[0],u[1])}function o(l,u){return ue(l[0]-e)<Ht?u>0?0:3:ue(l[0]-n)<Ht?u>0?2:1:ue(l[1]-t)<Ht?u>0?1:0:u>0?3:2}function a(l,u){return c(l.x,u.x)}function c(l,u){var h=o(l,1),f=o(u,1);return h!==f?h-f:h===0?u[1]-l[1]:h===1?l[0]-u[0]:h===2?l[1]-u[1]:u[0]-l[0]}return function(l){var u=l,h=$1(),f,d,p,_,g,m,x,S,v,w,b,y={point:M,lineStart:N,lineEnd:k,polygonStart:C,polygonEnd:E};function M(L,B){r(L,B)&&u.point(L,B)}function R(){for(var L=0,B=0,U=d.length;B<U;++B)for(var Z=d[B],F=1,G=Z.length,q=Z[0],rt,ct,$=q[0],ot=q[1];F<G;++F)rt=$,ct=ot,q=Z[F],$=q[0],ot=q[1],ct<=i?ot>i&&($-rt)*(i-ct)>(ot-ct)*(e-rt)&&++L:ot<=i&&($-rt)*(i-ct)<(ot-ct)*(e-rt)&&--L;return L}function C(){u=h,f=[],d=[],b=!0}function E(){var L=R(),B=b&&L,U=(f=hm(f)).length;(B||U)&&(l.polygonStart(),B&&(l.lineStart(),s(null,null,1,l),l.lineEnd()),U&&X1(f,a,L,s,l),l.polygonEnd()),u=l,f=d=p=null}function N(){y.point=P,d&&d.push(p=[]),w=!0,v=!1,x=S=NaN}function k(){f&&(P(_,g),m&&v&&h.rejoin(),f.push(h.result())),y.point=M,v&&u.lineEnd()}function P(L,B){var U=r(L,B);if(d&&p.push([L,B]),w)_=L,g=B,m=U,w=!1,U&&(u.lineStart(),u.point(L,B));else if(U&&v)u.point(L,B);else{var Z=[x=Math.max(sh,Math.min(Gc,x)),S=Math.max(sh,Math.min(Gc,S))],F=[L=Math.max(sh,Math.min(Gc,L)),B=Math.max(sh,Math.min(Gc,B))];YD(Z,F,e,t,n,i)?(v||(u.lineStart(),u.point(Z[0],Z[1])),u.point(F[0],F[1]),U||u.lineEnd(),b=!1):U&&(u.lineStart(),u.point(L,B),b=!1)}x=L,S=B,v=U}return y}}var Wm=e=>e,Om=new Qn,$m=new Qn,Y1,Z1,Xm,qm,Sr={point:oi,lineStart:oi,lineEnd:oi,polygonStart:function(){Sr.lineStart=ZD,Sr.lineEnd=KD},polygonEnd:function(){Sr.lineStart=Sr.lineEnd=Sr.point=oi,Om.add(ue($m)),$m=new Qn},result:function(){var e=Om/2;return Om=new Qn,e}};function ZD(){Sr.point=JD}function JD(e,t){Sr.point=J1,Y1=Xm=e,Z1=qm=t}function J1(e,t){$m.add(qm*e-Xm*t),Xm=e,qm=t}function KD(){J1(Y1,Z1)}var ua=1/0,fh=ua,Jc=-ua,hh=Jc,dh={point:jD,lineStart:oi,lineEnd:oi,polygonStart:oi,polygonEnd:oi,result:function(){var e=[[ua,fh],[Jc,hh]];return Jc=hh=-(fh=ua=1/0),e}};function jD(e,t){e<ua&&(ua=e),e>Jc&&(Jc=e),t<fh&&(fh=t),t>hh&&(hh=t)}var Ym=0,Zm=0,Vc=0,ph=0,mh=0,ca=0,Jm=0,Km=0,Hc=0,K1,j1,$i,Xi,ri={point:Hs,lineStart:N1,lineEnd:D1,polygonStart:function(){ri.lineStart=eU,ri.lineEnd=nU},polygonEnd:function(){ri.point=Hs,ri.lineStart=N1,ri.lineEnd=D1},result:function(){var e=Hc?[Jm/Hc,Km/Hc]:ca?[ph/ca,mh/ca]:Vc?[Ym/Vc,Zm/Vc]:[NaN,NaN];return Ym=Zm=Vc=ph=mh=ca=Jm=Km=Hc=0,e}};function Hs(e,t){Ym+=e,Zm+=t,++Vc}function N1(){ri.point=QD}function QD(e,t){ri.point=tU,Hs($i=e,Xi=t)}function tU(e,t){var n=e-$i,i=t-Xi,r=Rn(n*n+i*i);ph+=r*($i+e)/2,mh+=r*(Xi+t)/2,ca+=r,Hs($i=e,Xi=t)}function D1(){ri.point=Hs}function eU(){ri.point=iU}function nU(){Q1(K1,j1)}function iU(e,t){ri.point=Q1,Hs(K1=$i=e,j1=Xi=t)}function Q1(e,t){var n=e-$i,i=t-Xi,r=Rn(n*n+i*i);ph+=r*($i+e)/2,mh+=r*(Xi+t)/2,ca+=r,r=Xi*e-$i*t,Jm+=r*($i+e),Km+=r*(Xi+t),Hc+=r*3,Hs($i=e,Xi=t)}function tM(e){this._context=e}tM.prototype={_radius:4.5,pointRadius:function(e){return this._radius=e,this},polygonStart:function(){this._line=0},polygonEnd:function(){this._line=NaN},lineStart:function(){this._point=0},lineEnd:function(){this._line===0&&this._context.closePath(),this._point=NaN},point:function(e,t){switch(this._point){case 0:{this._context.moveTo(e,t),this._point=1;break}case 1:{this._context.lineTo(e,t);break}default:{this._context.moveTo(e+this._radius,t),this._context.arc(e,t,this._radius,0,Gn);break}}},result:oi};var jm=new Qn,Bm,eM,nM,Wc,$c,Kc={point:oi,lineStart:function(){Kc.point=rU},lineEnd:function(){Bm&&iM(eM,nM),Kc.point=oi},polygonStart:function(){Bm=!0},polygonEnd:function(){Bm=null},result:function(){var e=+jm;return jm=new Qn,e}};function rU(e,t){Kc.point=iM,eM=Wc=e,nM=$c=t}function iM(e,t){Wc-=e,$c-=t,jm.add(Rn(Wc*Wc+$c*$c)),Wc=e,$c=t}var U1,gh,F1,O1,_h=class{constructor(t){this._append=t==null?rM:sU(t),this._radius=4.5,this._=""}pointRadius(t){return this._radius=+t,this}polygonStart(){this._line=0}polygonEnd(){this._line=NaN}lineStart(){this._point=0}lineEnd(){this._line===0&&(this._+="Z"),this._point=NaN}point(t,n){switch(this._point){case 0:{this._append`M${t},${n}`,this._point=1;break}case 1:{this._append`L${t},${n}`;break}default:{if(this._append`M${t},${n}`,this._radius!==F1||this._append!==gh){let i=this._radius,r=this._;this._="",this._append`m0,${i}a${i},${i} 0 1,1 0,${-2*i}a${i},${i} 0 1,1 0,${2*i}z`,F1=i,gh=this._append,O1=this._,this._=r}this._+=O1;break}}}result(){let t=this._;return this._="",t.length?t:null}};function rM(e){let t=1;this._+=e[0];for(let n=e.length;t<n;++t)this._+=arguments[t]+e[t]}function sU(e){let t=Math.floor(e);if(!(t>=0))throw new RangeError(`invalid digits: ${e}`);if(t>15)return rM;if(t!==U1){let n=10**t;U1=t,gh=function(r){let s=1;this._+=r[0];for(let o=r.length;s<o;++s)this._+=Math.round(arguments[s]*n)/n+r[s]}}return gh}function Qc(e,t){let n=3,i=4.5,r,s;function o(a){return a&&(typeof i=="function"&&s.pointRadius(+i.apply(this,arguments)),as(a,r(s))),s.result()}return o.area=function(a){return as(a,r(Sr)),Sr.result()},o.measure=function(a){return as(a,r(Kc)),Kc.result()},o.bounds=function(a){return as(a,r(dh)),dh.result()},o.centroid=function(a){return as(a,r(ri)),ri.result()},o.projection=function(a){return arguments.length?(r=a==null?(e=null,Wm):(e=a).stream,o):e},o.context=function(a){return arguments.length?(s=a==null?(t=null,new _h(n)):new tM(t=a),typeof i!="function"&&s.pointRadius(i),o):t},o.pointRadius=function(a){return arguments.length?(i=typeof a=="function"?a:(s.pointRadius(+a),+a),o):i},o.digits=function(a){if(!arguments.length)return n;if(a==null)n=null;else{let c=Math.floor(a);if(!(c>=0))throw new RangeError(`invalid digits: ${a}`);n=c}return t===null&&(s=new _h(n)),o},o.projection(e).digits(n).context(t)}function tl(e){return{stream:vh(e)}}function vh(e){return function(t){var n=new Qm;for(var i in e)n[i]=e[i];return n.stream=t,n}}function Qm(){}Qm.prototype={constructor:Qm,point:function(e,t){this.stream.point(e,t)},sphere:function(){this.stream.sphere()},lineStart:function(){this.stream.lineStart()},lineEnd:function(){this.stream.lineEnd()},polygonStart:function(){this.stream.polygonStart()},polygonEnd:function(){this.stream.polygonEnd()}};function ng(e,t,n){var i=e.clipExtent&&e.clipExtent();return e.scale(150).translate([0,0]),i!=null&&e.clipExtent(null),as(n,e.stream(dh)),t(dh.result()),i!=null&&e.clipExtent(i),e}function ig(e,t,n){return ng(e,function(i){var r=t[1][0]-t[0][0],s=t[1][1]-t[0][1],o=Math.min(r/(i[1][0]-i[0][0]),s/(i[1][1]-i[0][1])),a=+t[0][0]+(r-o*(i[1][0]+i[0][0]))/2,c=+t[0][1]+(s-o*(i[1][1]+i[0][1]))/2;e.scale(150*o).translate([a,c])},n)}function sM(e,t,n){return ig(e,[[0,0],t],n)}function oM(e,t,n){return ng(e,function(i){var r=+t,s=r/(i[1][0]-i[0][0]),o=(r-s*(i[1][0]+i[0][0]))/2,a=-s*i[0][1];e.scale(150*s).translate([o,a])},n)}function aM(e,t,n){return ng(e,function(i){var r=+t,s=r/(i[1][1]-i[0][1]),o=-s*i[0][0],a=(r-s*(i[1][1]+i[0][1]))/2;e.scale(150*s).translate([o,a])},n)}var B1=16,oU=Jt(30*Ae);function k1(e,t){return+t?cU(e,t):aU(e)}function aU(e){return vh({point:function(t,n){t=e(t,n),this.stream.point(t[0],t[1])}})}function cU(e,t){function n(i,r,s,o,a,c,l,u,h,f,d,p,_,g){var m=l-i,x=u-r,S=m*m+x*x;if(S>4*t&&_--){var v=o+f,w=a+d,b=c+p,y=Rn(v*v+w*w+b*b),M=ai(b/=y),R=ue(ue(b)-1)<Ht||ue(s-h)<Ht?(s+h)/2:wr(w,v),C=e(R,M),E=C[0],N=C[1],k=E-i,P=N-r,L=x*k-m*P;(L*L/S>t||ue((m*k+x*P)/S-.5)>.3||o*f+a*d+c*p<oU)&&(n(i,r,s,o,a,c,E,N,R,v/=y,w/=y,b,_,g),g.point(E,N),n(E,N,R,v,w,b,l,u,h,f,d,p,_,g))}}return function(i){var r,s,o,a,c,l,u,h,f,d,p,_,g={point:m,lineStart:x,lineEnd:v,polygonStart:function(){i.polygonStart(),g.lineStart=w},polygonEnd:function(){i.polygonEnd(),g.lineStart=x}};function m(M,R){M=e(M,R),i.point(M[0],M[1])}function x(){h=NaN,g.point=S,i.lineStart()}function S(M,R){var C=la([M,R]),E=e(M,R);n(h,f,u,d,p,_,h=E[0],f=E[1],u=M,d=C[0],p=C[1],_=C[2],B1,i),i.point(h,f)}function v(){g.point=m,i.lineEnd()}function w(){x(),g.point=b,g.lineEnd=y}function b(M,R){S(r=M,R),s=h,o=f,a=d,c=p,l=_,g.point=S}function y(){n(h,f,u,d,p,_,s,o,r,a,c,l,B1,i),g.lineEnd=v,v()}return g}}var lU=vh({point:function(e,t){this.stream.point(e*Ae,t*Ae)}});function uU(e){return vh({point:function(t,n){var i=e(t,n);return this.stream.point(i[0],i[1])}})}function fU(e,t,n,i,r){function s(o,a){return o*=i,a*=r,[t+e*o,n-e*a]}return s.invert=function(o,a){return[(o-t)/e*i,(n-a)/e*r]},s}function z1(e,t,n,i,r,s){if(!s)return fU(e,t,n,i,r);var o=Jt(s),a=Wt(s),c=o*e,l=a*e,u=o/e,h=a/e,f=(a*n-o*t)/e,d=(a*t+o*n)/e;function p(_,g){return _*=i,g*=r,[c*_-l*g+t,n-l*_-c*g]}return p.invert=function(_,g){return[i*(u*_-h*g+f),r*(d-h*_-u*g)]},p}function cs(e){return cM(function(){return e})()}function cM(e){var t,n=150,i=480,r=250,s=0,o=0,a=0,c=0,l=0,u,h=0,f=1,d=1,p=null,_=L1,g=null,m,x,S,v=Wm,w=.5,b,y,M,R,C;function E(L){return M(L[0]*Ae,L[1]*Ae)}function N(L){return L=M.invert(L[0],L[1]),L&&[L[0]*Sn,L[1]*Sn]}E.stream=function(L){return R&&C===L?R:R=lU(uU(u)(_(b(v(C=L)))))},E.preclip=function(L){return arguments.length?(_=L,p=void 0,P()):_},E.postclip=function(L){return arguments.length?(v=L,g=m=x=S=null,P()):v},E.clipAngle=function(L){return arguments.length?(_=+L?qD(p=L*Ae):(p=null,L1),P()):p*Sn},E.clipExtent=function(L){return arguments.length?(v=L==null?(g=m=x=S=null,Wm):eg(g=+L[0][0],m=+L[0][1],x=+L[1][0],S=+L[1][1]),P()):g==null?null:[[g,m],[x,S]]},E.scale=function(L){return arguments.length?(n=+L,k()):n},E.translate=function(L){return arguments.length?(i=+L[0],r=+L[1],k()):[i,r]},E.center=function(L){return arguments.length?(s=L[0]%360*Ae,o=L[1]%360*Ae,k()):[s*Sn,o*Sn]},E.rotate=function(L){return arguments.length?(a=L[0]%360*Ae,c=L[1]%360*Ae,l=L.length>2?L[2]%360*Ae:0,k()):[a*Sn,c*Sn,l*Sn]},E.angle=function(L){return arguments.length?(h=L%360*Ae,k()):h*Sn},E.reflectX=function(L){return arguments.length?(f=L?-1:1,k()):f<0},E.reflectY=function(L){return arguments.length?(d=L?-1:1,k()):d<0},E.precision=function(L){return arguments.length?(b=k1(y,w=L*L),P()):Rn(w)},E.fitExtent=function(L,B){return ig(E,L,B)},E.fitSize=function(L,B){return sM(E,L,B)},E.fitWidth=function(L,B){return oM(E,L,B)},E.fitHeight=function(L,B){return aM(E,L,B)};function k(){var L=z1(n,0,0,f,d,h).apply(null,t(s,o)),B=z1(n,i-L[0],r-L[1],f,d,h);return u=W1(a,c,l),y=Vm(t,B),M=Vm(u,y),b=k1(y,w),P()}function P(){return R=C=null,E}return function(){return t=e.apply(this,arguments),E.invert=t.invert&&N,k()}}function rg(e){var t=0,n=Qt/3,i=cM(e),r=i(t,n);return r.parallels=function(s){return arguments.length?i(t=s[0]*Ae,n=s[1]*Ae):[t*Sn,n*Sn]},r}function hU(e){var t=Jt(e);function n(i,r){return[i*t,Wt(r)/t]}return n.invert=function(i,r){return[i/t,ai(r*t)]},n}function dU(e,t){var n=Wt(e),i=(n+Wt(t))/2;if(ue(i)<Ht)return hU(e);var r=1+n*(2*i-n),s=Rn(r)/i;function o(a,c){var l=Rn(r-2*i*Wt(c))/i;return[l*Wt(a*=i),s-l*Jt(a)]}return o.invert=function(a,c){var l=s-c,u=wr(a,ue(l))*si(l);return l*i<0&&(u-=Qt*si(a)*si(l)),[u/i,ai((r-(a*a+l*l)*i*i)/(2*i))]},o}function jc(){return rg(dU).scale(155.424).center([0,33.6442])}function sg(){return jc().parallels([29.5,45.5]).scale(1070).translate([480,250]).rotate([96,0]).center([-.6,38.7])}function pU(e){var t=e.length;return{point:function(n,i){for(var r=-1;++r<t;)e[r].point(n,i)},sphere:function(){for(var n=-1;++n<t;)e[n].sphere()},lineStart:function(){for(var n=-1;++n<t;)e[n].lineStart()},lineEnd:function(){for(var n=-1;++n<t;)e[n].lineEnd()},polygonStart:function(){for(var n=-1;++n<t;)e[n].polygonStart()},polygonEnd:function(){for(var n=-1;++n<t;)e[n].polygonEnd()}}}function lM(){var e,t,n=sg(),i,r=jc().rotate([154,0]).center([-2,58.5]).parallels([55,65]),s,o=jc().rotate([157,0]).center([-3,19.9]).parallels([8,18]),a,c,l={point:function(f,d){c=[f,d]}};function u(f){var d=f[0],p=f[1];return c=null,i.point(d,p),c||(s.point(d,p),c)||(a.point(d,p),c)}u.invert=function(f){var d=n.scale(),p=n.translate(),_=(f[0]-p[0])/d,g=(f[1]-p[1])/d;return(g>=.12&&g<.234&&_>=-.425&&_<-.214?r:g>=.166&&g<.234&&_>=-.214&&_<-.115?o:n).invert(f)},u.stream=function(f){return e&&t===f?e:e=pU([n.stream(t=f),r.stream(f),o.stream(f)])},u.precision=function(f){return arguments.length?(n.precision(f),r.precision(f),o.precision(f),h()):n.precision()},u.scale=function(f){return arguments.length?(n.scale(f),r.scale(f*.35),o.scale(f),u.translate(n.translate())):n.scale()},u.translate=function(f){if(!arguments.length)return n.translate();var d=n.scale(),p=+f[0],_=+f[1];return i=n.translate(f).clipExtent([[p-.455*d,_-.238*d],[p+.455*d,_+.238*d]]).stream(l),s=r.translate([p-.307*d,_+.201*d]).clipExtent([[p-.425*d+Ht,_+.12*d+Ht],[p-.214*d-Ht,_+.234*d-Ht]]).stream(l),a=o.translate([p-.205*d,_+.212*d]).clipExtent([[p-.214*d+Ht,_+.166*d+Ht],[p-.115*d-Ht,_+.234*d-Ht]]).stream(l),h()},u.fitExtent=function(f,d){return ig(u,f,d)},u.fitSize=function(f,d){return sM(u,f,d)},u.fitWidth=function(f,d){return oM(u,f,d)},u.fitHeight=function(f,d){return aM(u,f,d)};function h(){return e=t=null,u}return u.scale(1070)}function uM(e){return function(t,n){var i=Jt(t),r=Jt(n),s=e(i*r);return s===1/0?[2,0]:[s*r*Wt(t),s*Wt(n)]}}function el(e){return function(t,n){var i=Rn(t*t+n*n),r=e(i),s=Wt(r),o=Jt(r);return[wr(t*s,i*o),ai(i&&n*s/i)]}}var fM=uM(function(e){return Rn(2/(1+e))});fM.invert=el(function(e){return 2*ai(e/2)});function hM(){return cs(fM).scale(124.75).clipAngle(180-.001)}var dM=uM(function(e){return(e=H1(e))&&e/Wt(e)});dM.invert=el(function(e){return e});function pM(){return cs(dM).scale(79.4188).clipAngle(180-.001)}function bh(e,t){return[e,ch(tg((Ee+t)/2))]}bh.invert=function(e,t){return[e,2*fa(V1(t))-Ee]};function mM(){return gM(bh).scale(961/Gn)}function gM(e){var t=cs(e),n=t.center,i=t.scale,r=t.translate,s=t.clipExtent,o=null,a,c,l;t.scale=function(h){return arguments.length?(i(h),u()):i()},t.translate=function(h){return arguments.length?(r(h),u()):r()},t.center=function(h){return arguments.length?(n(h),u()):n()},t.clipExtent=function(h){return arguments.length?(h==null?o=a=c=l=null:(o=+h[0][0],a=+h[0][1],c=+h[1][0],l=+h[1][1]),u()):o==null?null:[[o,a],[c,l]]};function u(){var h=Qt*i(),f=t(kD(t.rotate()).invert([0,0]));return s(o==null?[[f[0]-h,f[1]-h],[f[0]+h,f[1]+h]]:e===bh?[[Math.max(f[0]-h,o),a],[Math.min(f[0]+h,c),l]]:[[o,Math.max(f[1]-h,a)],[c,Math.min(f[1]+h,l)]])}return u()}function oh(e){return tg((Ee+e)/2)}function mU(e,t){var n=Jt(e),i=e===t?Wt(e):ch(n/Jt(t))/ch(oh(t)/oh(e)),r=n*Dm(oh(e),i)/i;if(!i)return bh;function s(o,a){r>0?a<-Ee+Ht&&(a=-Ee+Ht):a>Ee-Ht&&(a=Ee-Ht);var c=r/Dm(oh(a),i);return[c*Wt(i*o),r-c*Jt(i*o)]}return s.invert=function(o,a){var c=r-a,l=si(i)*Rn(o*o+c*c),u=wr(o,ue(c))*si(c);return c*i<0&&(u-=Qt*si(o)*si(c)),[u/i,2*fa(Dm(r/l,1/i))-Ee]},s}function _M(){return rg(mU).scale(109.5).parallels([30,30])}function yh(e,t){return[e,t]}yh.invert=yh;function yM(){return cs(yh).scale(152.63)}function gU(e,t){var n=Jt(e),i=e===t?Wt(e):(n-Jt(t))/(t-e),r=n/i+e;if(ue(i)<Ht)return yh;function s(o,a){var c=r-a,l=i*o;return[c*Wt(l),r-c*Jt(l)]}return s.invert=function(o,a){var c=r-a,l=wr(o,ue(c))*si(c);return c*i<0&&(l-=Qt*si(o)*si(c)),[l/i,r-si(i)*Rn(o*o+c*c)]},s}function xM(){return rg(gU).scale(131.154).center([0,13.9389])}var Xc=1.340264,qc=-.081106,Yc=893e-6,Zc=.003796,xh=Rn(3)/2,_U=12;function vM(e,t){var n=ai(xh*Wt(t)),i=n*n,r=i*i*i;return[e*Jt(n)/(xh*(Xc+3*qc*i+r*(7*Yc+9*Zc*i))),n*(Xc+qc*i+r*(Yc+Zc*i))]}vM.invert=function(e,t){for(var n=t,i=n*n,r=i*i*i,s=0,o,a,c;s<_U&&(a=n*(Xc+qc*i+r*(Yc+Zc*i))-t,c=Xc+3*qc*i+r*(7*Yc+9*Zc*i),n-=o=a/c,i=n*n,r=i*i*i,!(ue(o)<G1));++s);return[xh*e*(Xc+3*qc*i+r*(7*Yc+9*Zc*i))/Jt(n),ai(Wt(n)/xh)]};function bM(){return cs(vM).scale(177.158)}function MM(e,t){var n=Jt(t),i=Jt(e)*n;return[n*Wt(e)/i,Wt(t)/i]}MM.invert=el(fa);function SM(){return cs(MM).scale(144.049).clipAngle(60)}function yU(e,t){var n=t*t,i=n*n;return[e*(.8707-.131979*n+i*(-.013791+i*(.003971*n-.001529*i))),t*(1.007226+n*(.015085+i*(-.044475+.028874*n-.005916*i)))]}yU.invert=function(e,t){var n=t,i=25,r;do{var s=n*n,o=s*s;n-=r=(n*(1.007226+s*(.015085+o*(-.044475+.028874*s-.005916*o)))-t)/(1.007226+s*(.015085*3+o*(-.044475*7+.028874*9*s-.005916*11*o)))}while(ue(r)>Ht&&--i>0);return[e/(.8707+(s=n*n)*(-.131979+s*(-.013791+s*s*s*(.003971-.001529*s)))),n]};function wM(e,t){return[Jt(t)*Wt(e),Wt(t)]}wM.invert=el(ai);function TM(){return cs(wM).scale(249.5).clipAngle(90+Ht)}function AM(e,t){var n=Jt(t),i=1+Jt(e)*n;return[n*Wt(e)/i,Wt(t)/i]}AM.invert=el(function(e){return 2*fa(e)});function EM(){return cs(AM).scale(250).clipAngle(142)}function CM(e,t){return[ch(tg((Ee+t)/2)),-e]}CM.invert=function(e,t){return[-t,2*fa(V1(e))-Ee]};function RM(){var e=gM(CM),t=e.center,n=e.rotate;return e.center=function(i){return arguments.length?t([-i[1],i[0]]):(i=t(),[i[1],-i[0]])},e.rotate=function(i){return arguments.length?n([i[0],i[1],i.length>2?i[2]+90:90]):(i=n(),[i[0],i[1],i[2]-90])},n([0,0,90]).scale(159.155)}var og=new Date,ag=new Date;function ze(e,t,n,i){function r(s){return e(s=arguments.length===0?new Date:new Date(+s)),s}return r.floor=s=>(e(s=new Date(+s)),s),r.ceil=s=>(e(s=new Date(s-1)),t(s,1),e(s),s),r.round=s=>{let o=r(s),a=r.ceil(s);return s-o<a-s?o:a},r.offset=(s,o)=>(t(s=new Date(+s),o==null?1:Math.floor(o)),s),r.range=(s,o,a)=>{let c=[];if(s=r.ceil(s),a=a==null?1:Math.floor(a),!(s<o)||!(a>0))return c;let l;do c.push(l=new Date(+s)),t(s,a),e(s);while(l<s&&s<o);return c},r.filter=s=>ze(o=>{if(o>=o)for(;e(o),!s(o);)o.setTime(o-1)},(o,a)=>{if(o>=o)if(a<0)for(;++a<=0;)for(;t(o,-1),!s(o););else for(;--a>=0;)for(;t(o,1),!s(o););}),n&&(r.count=(s,o)=>(og.setTime(+s),ag.setTime(+o),e(og),e(ag),Math.floor(n(og,ag))),r.every=s=>(s=Math.floor(s),!isFinite(s)||!(s>0)?null:s>1?r.filter(i?o=>i(o)%s===0:o=>r.count(0,o)%s===0):r)),r}var Mh=ze(()=>{},(e,t)=>{e.setTime(+e+t)},(e,t)=>t-e);Mh.every=e=>(e=Math.floor(e),!isFinite(e)||!(e>0)?null:e>1?ze(t=>{t.setTime(Math.floor(t/e)*e)},(t,n)=>{t.setTime(+t+n*e)},(t,n)=>(n-t)/e):Mh);var ez=Mh.range,Tr=1e3,ci=Tr*60,Ar=ci*60,Er=Ar*24,lg=Er*7,PM=Er*30,cg=Er*365,wn=ze(e=>{e.setTime(e-e.getMilliseconds())},(e,t)=>{e.setTime(+e+t*Tr)},(e,t)=>(t-e)/Tr,e=>e.getUTCSeconds()),nz=wn.range,Ws=ze(e=>{e.setTime(e-e.getMilliseconds()-e.getSeconds()*Tr)},(e,t)=>{e.setTime(+e+t*ci)},(e,t)=>(t-e)/ci,e=>e.getMinutes()),iz=Ws.range,$s=ze(e=>{e.setUTCSeconds(0,0)},(e,t)=>{e.setTime(+e+t*ci)},(e,t)=>(t-e)/ci,e=>e.getUTCMinutes()),rz=$s.range,Xs=ze(e=>{e.setTime(e-e.getMilliseconds()-e.getSeconds()*Tr-e.getMinutes()*ci)},(e,t)=>{e.setTime(+e+t*Ar)},(e,t)=>(t-e)/Ar,e=>e.getHours()),sz=Xs.range,qs=ze(e=>{e.setUTCMinutes(0,0,0)},(e,t)=>{e.setTime(+e+t*Ar)},(e,t)=>(t-e)/Ar,e=>e.getUTCHours()),oz=qs.range,qi=ze(e=>e.setHours(0,0,0,0),(e,t)=>e.setDate(e.getDate()+t),(e,t)=>(t-e-(t.getTimezoneOffset()-e.getTimezoneOffset())*ci)/Er,e=>e.getDate()-1),az=qi.range,ha=ze(e=>{e.setUTCHours(0,0,0,0)},(e,t)=>{e.setUTCDate(e.getUTCDate()+t)},(e,t)=>(t-e)/Er,e=>e.getUTCDate()-1),cz=ha.range,nl=ze(e=>{e.setUTCHours(0,0,0,0)},(e,t)=>{e.setUTCDate(e.getUTCDate()+t)},(e,t)=>(t-e)/Er,e=>Math.floor(e/Er)),lz=nl.range;function Ys(e){return ze(t=>{t.setDate(t.getDate()-(t.getDay()+7-e)%7),t.setHours(0,0,0,0)},(t,n)=>{t.setDate(t.getDate()+n*7)},(t,n)=>(n-t-(n.getTimezoneOffset()-t.getTimezoneOffset())*ci)/lg)}var Yi=Ys(0),Zs=Ys(1),ug=Ys(2),fg=Ys(3),Cr=Ys(4),hg=Ys(5),dg=Ys(6),uz=Yi.range,fz=Zs.range,hz=ug.range,dz=fg.range,pz=Cr.range,mz=hg.range,gz=dg.range;function Js(e){return ze(t=>{t.setUTCDate(t.getUTCDate()-(t.getUTCDay()+7-e)%7),t.setUTCHours(0,0,0,0)},(t,n)=>{t.setUTCDate(t.getUTCDate()+n*7)},(t,n)=>(n-t)/lg)}var Zi=Js(0),Ks=Js(1),pg=Js(2),mg=Js(3),Rr=Js(4),gg=Js(5),_g=Js(6),_z=Zi.range,yz=Ks.range,xz=pg.range,vz=mg.range,bz=Rr.range,Mz=gg.range,Sz=_g.range,js=ze(e=>{e.setDate(1),e.setHours(0,0,0,0)},(e,t)=>{e.setMonth(e.getMonth()+t)},(e,t)=>t.getMonth()-e.getMonth()+(t.getFullYear()-e.getFullYear())*12,e=>e.getMonth()),wz=js.range,Qs=ze(e=>{e.setUTCDate(1),e.setUTCHours(0,0,0,0)},(e,t)=>{e.setUTCMonth(e.getUTCMonth()+t)},(e,t)=>t.getUTCMonth()-e.getUTCMonth()+(t.getUTCFullYear()-e.getUTCFullYear())*12,e=>e.getUTCMonth()),Tz=Qs.range,Pn=ze(e=>{e.setMonth(0,1),e.setHours(0,0,0,0)},(e,t)=>{e.setFullYear(e.getFullYear()+t)},(e,t)=>t.getFullYear()-e.getFullYear(),e=>e.getFullYear());Pn.every=e=>!isFinite(e=Math.floor(e))||!(e>0)?null:ze(t=>{t.setFullYear(Math.floor(t.getFullYear()/e)*e),t.setMonth(0,1),t.setHours(0,0,0,0)},(t,n)=>{t.setFullYear(t.getFullYear()+n*e)});var Az=Pn.range,In=ze(e=>{e.setUTCMonth(0,1),e.setUTCHours(0,0,0,0)},(e,t)=>{e.setUTCFullYear(e.getUTCFullYear()+t)},(e,t)=>t.getUTCFullYear()-e.getUTCFullYear(),e=>e.getUTCFullYear());In.every=e=>!isFinite(e=Math.floor(e))||!(e>0)?null:ze(t=>{t.setUTCFullYear(Math.floor(t.getUTCFullYear()/e)*e),t.setUTCMonth(0,1),t.setUTCHours(0,0,0,0)},(t,n)=>{t.setUTCFullYear(t.getUTCFullYear()+n*e)});var Ez=In.range;function IM(e,t,n,i,r,s){let o=[[wn,1,Tr],[wn,5,5*Tr],[wn,15,15*Tr],[wn,30,30*Tr],[s,1,ci],[s,5,5*ci],[s,15,15*ci],[s,30,30*ci],[r,1,Ar],[r,3,3*Ar],[r,6,6*Ar],[r,12,12*Ar],[i,1,Er],[i,2,2*Er],[n,1,lg],[t,1,PM],[t,3,3*PM],[e,1,cg]];function a(l,u,h){let f=u<l;f&&([l,u]=[u,l]);let d=h&&typeof h.range=="function"?h:c(l,u,h),p=d?d.range(l,+u+1):[];return f?p.reverse():p}function c(l,u,h){let f=Math.abs(u-l)/h,d=Yo(([,,g])=>g).right(o,f);if(d===o.length)return e.every(Dc(l/cg,u/cg,h));if(d===0)return Mh.every(Math.max(Dc(l,u,h),1));let[p,_]=o[f/o[d-1][2]<o[d][2]/f?d-1:d];return p.every(_)}return[a,c]}var[LM,NM]=IM(In,Qs,Zi,nl,qs,$s),[DM,UM]=IM(Pn,js,Yi,qi,Xs,Ws);function yg(e){if(0<=e.y&&e.y<100){var t=new Date(-1,e.m,e.d,e.H,e.M,e.S,e.L);return t.setFullYear(e.y),t}return new Date(e.y,e.m,e.d,e.H,e.M,e.S,e.L)}function xg(e){if(0<=e.y&&e.y<100){var t=new Date(Date.UTC(-1,e.m,e.d,e.H,e.M,e.S,e.L));return t.setUTCFullYear(e.y),t}return new Date(Date.UTC(e.y,e.m,e.d,e.H,e.M,e.S,e.L))}function il(e,t,n){return{y:e,m:t,d:n,H:0,M:0,S:0,L:0}}function xU(e){var t=e.dateTime,n=e.date,i=e.time,r=e.periods,s=e.days,o=e.shortDays,a=e.months,c=e.shortMonths,l=rl(r),u=sl(r),h=rl(s),f=sl(s),d=rl(o),p=sl(o),_=rl(a),g=sl(a),m=rl(c),x=sl(c),S={a:U,A:Z,b:F,B:G,c:null,d:GM,e:GM,f:VU,g:jU,G:tF,H:kU,I:zU,j:GU,L:XM,m:HU,M:WU,p:q,q:rt,Q:WM,s:$M,S:$U,u:XU,U:qU,V:YU,w:ZU,W:JU,x:null,X:null,y:KU,Y:QU,Z:eF,"%":HM},v={a:ct,A:$,b:ot,B:ut,c:null,d:VM,e:VM,f:sF,g:mF,G:_F,H:nF,I:iF,j:rF,L:YM,m:oF,M:aF,p:st,q:at,Q:WM,s:$M,S:cF,u:lF,U:uF,V:fF,w:hF,W:dF,x:null,X:null,y:pF,Y:gF,Z:yF,"%":HM},w={a:C,A:E,b:N,B:k,c:P,d:kM,e:kM,f:UU,g:BM,G:OM,H:zM,I:zM,j:IU,L:DU,m:PU,M:LU,p:R,q:RU,Q:OU,s:BU,S:NU,u:wU,U:TU,V:AU,w:SU,W:EU,x:L,X:B,y:BM,Y:OM,Z:CU,"%":FU};S.x=b(n,S),S.X=b(i,S),S.c=b(t,S),v.x=b(n,v),v.X=b(i,v),v.c=b(t,v);function b(J,yt){return function(lt){var K=[],Lt=-1,Mt=0,Vt=J.length,Xt,he,ce;for(lt instanceof Date||(lt=new Date(+lt));++Lt<Vt;)J.charCodeAt(Lt)===37&&(K.push(J.slice(Mt,Lt)),(he=FM[Xt=J.charAt(++Lt)])!=null?Xt=J.charAt(++Lt):he=Xt==="e"?" ":"0",(ce=yt[Xt])&&(Xt=ce(lt,he)),K.push(Xt),Mt=Lt+1);return K.push(J.slice(Mt,Lt)),K.join("")}}function y(J,yt){return function(lt){var K=il(1900,void 0,1),Lt=M(K,J,lt+="",0),Mt,Vt;if(Lt!=lt.length)return null;if("Q"in K)return new Date(K.Q);if("s"in K)return new Date(K.s*1e3+("L"in K?K.L:0));if(yt&&!("Z"in K)&&(K.Z=0),"p"in K&&(K.H=K.H%12+K.p*12),K.m===void 0&&(K.m="q"in K?K.q:0),"V"in K){if(K.V<1||K.V>53)return null;"w"in K||(K.w=1),"Z"in K?(Mt=xg(il(K.y,0,1)),Vt=Mt.getUTCDay(),Mt=Vt>4||Vt===0?Ks.ceil(Mt):Ks(Mt),Mt=ha.offset(Mt,(K.V-1)*7),K.y=Mt.getUTCFullYear(),K.m=Mt.getUTCMonth(),K.d=Mt.getUTCDate()+(K.w+6)%7):(Mt=yg(il(K.y,0,1)),Vt=Mt.getDay(),Mt=Vt>4||Vt===0?Zs.ceil(Mt):Zs(Mt),Mt=qi.offset(Mt,(K.V-1)*7),K.y=Mt.getFullYear(),K.m=Mt.getMonth(),K.d=Mt.getDate()+(K.w+6)%7)}else("W"in K||"U"in K)&&("w"in K||(K.w="u"in K?K.u%7:"W"in K?1:0),Vt="Z"in K?xg(il(K.y,0,1)).getUTCDay():yg(il(K.y,0,1)).getDay(),K.m=0,K.d="W"in K?(K.w+6)%7+K.W*7-(Vt+5)%7:K.w+K.U*7-(Vt+6)%7);return"Z"in K?(K.H+=K.Z/100|0,K.M+=K.Z%100,xg(K)):yg(K)}}function M(J,yt,lt,K){for(var Lt=0,Mt=yt.length,Vt=lt.length,Xt,he;Lt<Mt;){if(K>=Vt)return-1;if(Xt=yt.charCodeAt(Lt++),Xt===37){if(Xt=yt.charAt(Lt++),he=w[Xt in FM?yt.charAt(Lt++):Xt],!he||(K=he(J,lt,K))<0)return-1}else if(Xt!=lt.charCodeAt(K++))return-1}return K}function R(J,yt,lt){var K=l.exec(yt.slice(lt));return K?(J.p=u.get(K[0].toLowerCase()),lt+K[0].length):-1}function C(J,yt,lt){var K=d.exec(yt.slice(lt));return K?(J.w=p.get(K[0].toLowerCase()),lt+K[0].length):-1}function E(J,yt,lt){var K=h.exec(yt.slice(lt));return K?(J.w=f.get(K[0].toLowerCase()),lt+K[0].length):-1}function N(J,yt,lt){var K=m.exec(yt.slice(lt));return K?(J.m=x.get(K[0].toLowerCase()),lt+K[0].length):-1}function k(J,yt,lt){var K=_.exec(yt.slice(lt));return K?(J.m=g.get(K[0].toLowerCase()),lt+K[0].length):-1}function P(J,yt,lt){return M(J,t,yt,lt)}function L(J,yt,lt){return M(J,n,yt,lt)}function B(J,yt,lt){return M(J,i,yt,lt)}function U(J){return o[J.getDay()]}function Z(J){return s[J.getDay()]}function F(J){return c[J.getMonth()]}function G(J){return a[J.getMonth()]}function q(J){return r[+(J.getHours()>=12)]}function rt(J){return 1+~~(J.getMonth()/3)}function ct(J){return o[J.getUTCDay()]}function $(J){return s[J.getUTCDay()]}function ot(J){return c[J.getUTCMonth()]}function ut(J){return a[J.getUTCMonth()]}function st(J){return r[+(J.getUTCHours()>=12)]}function at(J){return 1+~~(J.getUTCMonth()/3)}return{format:function(J){var yt=b(J+="",S);return yt.toString=function(){return J},yt},parse:function(J){var yt=y(J+="",!1);return yt.toString=function(){return J},yt},utcFormat:function(J){var yt=b(J+="",v);return yt.toString=function(){return J},yt},utcParse:function(J){var yt=y(J+="",!0);return yt.toString=function(){return J},yt}}}var FM={"-":"",_:" ",0:"0"},Ke=/^\s*\d+/,vU=/^%/,bU=/[\\^$*+?|[\]().{}]/g;function re(e,t,n){var i=e<0?"-":"",r=(i?-e:e)+"",s=r.length;return i+(s<n?new Array(n-s+1).join(t)+r:r)}function MU(e){return e.replace(bU,"\\$&")}function rl(e){return new RegExp("^(?:"+e.map(MU).join("|")+")","i")}function sl(e){return new Map(e.map((t,n)=>[t.toLowerCase(),n]))}function SU(e,t,n){var i=Ke.exec(t.slice(n,n+1));return i?(e.w=+i[0],n+i[0].length):-1}function wU(e,t,n){var i=Ke.exec(t.slice(n,n+1));return i?(e.u=+i[0],n+i[0].length):-1}function TU(e,t,n){var i=Ke.exec(t.slice(n,n+2));return i?(e.U=+i[0],n+i[0].length):-1}function AU(e,t,n){var i=Ke.exec(t.slice(n,n+2));return i?(e.V=+i[0],n+i[0].length):-1}function EU(e,t,n){var i=Ke.exec(t.slice(n,n+2));return i?(e.W=+i[0],n+i[0].length):-1}function OM(e,t,n){var i=Ke.exec(t.slice(n,n+4));return i?(e.y=+i[0],n+i[0].length):-1}function BM(e,t,n){var i=Ke.exec(t.slice(n,n+2));return i?(e.y=+i[0]+(+i[0]>68?1900:2e3),n+i[0].length):-1}function CU(e,t,n){var i=/^(Z)|([+-]\d\d)(?::?(\d\d))?/.exec(t.slice(n,n+6));return i?(e.Z=i[1]?0:-(i[2]+(i[3]||"00")),n+i[0].length):-1}function RU(e,t,n){var i=Ke.exec(t.slice(n,n+1));return i?(e.q=i[0]*3-3,n+i[0].length):-1}function PU(e,t,n){var i=Ke.exec(t.slice(n,n+2));return i?(e.m=i[0]-1,n+i[0].length):-1}function kM(e,t,n){var i=Ke.exec(t.slice(n,n+2));return i?(e.d=+i[0],n+i[0].length):-1}function IU(e,t,n){var i=Ke.exec(t.slice(n,n+3));return i?(e.m=0,e.d=+i[0],n+i[0].length):-1}function zM(e,t,n){var i=Ke.exec(t.slice(n,n+2));return i?(e.H=+i[0],n+i[0].length):-1}function LU(e,t,n){var i=Ke.exec(t.slice(n,n+2));return i?(e.M=+i[0],n+i[0].length):-1}function NU(e,t,n){var i=Ke.exec(t.slice(n,n+2));return i?(e.S=+i[0],n+i[0].length):-1}function DU(e,t,n){var i=Ke.exec(t.slice(n,n+3));return i?(e.L=+i[0],n+i[0].length):-1}function UU(e,t,n){var i=Ke.exec(t.slice(n,n+6));return i?(e.L=Math.floor(i[0]/1e3),n+i[0].length):-1}function FU(e,t,n){var i=vU.exec(t.slice(n,n+1));return i?n+i[0].length:-1}function OU(e,t,n){var i=Ke.exec(t.slice(n));return i?(e.Q=+i[0],n+i[0].length):-1}function BU(e,t,n){var i=Ke.exec(t.slice(n));return i?(e.s=+i[0],n+i[0].length):-1}function GM(e,t){return re(e.getDate(),t,2)}function kU(e,t){return re(e.getHours(),t,2)}function zU(e,t){return re(e.getHours()%12||12,t,2)}function GU(e,t){return re(1+qi.count(Pn(e),e),t,3)}function XM(e,t){return re(e.getMilliseconds(),t,3)}function VU(e,t){return XM(e,t)+"000"}function HU(e,t){return re(e.getMonth()+1,t,2)}function WU(e,t){return re(e.getMinutes(),t,2)}function $U(e,t){return re(e.getSeconds(),t,2)}function XU(e){var t=e.getDay();return t===0?7:t}function qU(e,t){return re(Yi.count(Pn(e)-1,e),t,2)}function qM(e){var t=e.getDay();return t>=4||t===0?Cr(e):Cr.ceil(e)}function YU(e,t){return e=qM(e),re(Cr.count(Pn(e),e)+(Pn(e).getDay()===4),t,2)}function ZU(e){return e.getDay()}function JU(e,t){return re(Zs.count(Pn(e)-1,e),t,2)}function KU(e,t){return re(e.getFullYear()%100,t,2)}function jU(e,t){return e=qM(e),re(e.getFullYear()%100,t,2)}function QU(e,t){return re(e.getFullYear()%1e4,t,4)}function tF(e,t){var n=e.getDay();return e=n>=4||n===0?Cr(e):Cr.ceil(e),re(e.getFullYear()%1e4,t,4)}function eF(e){var t=e.getTimezoneOffset();return(t>0?"-":(t*=-1,"+"))+re(t/60|0,"0",2)+re(t%60,"0",2)}function VM(e,t){return re(e.getUTCDate(),t,2)}function nF(e,t){return re(e.getUTCHours(),t,2)}function iF(e,t){return re(e.getUTCHours()%12||12,t,2)}function rF(e,t){return re(1+ha.count(In(e),e),t,3)}function YM(e,t){return re(e.getUTCMilliseconds(),t,3)}function sF(e,t){return YM(e,t)+"000"}function oF(e,t){return re(e.getUTCMonth()+1,t,2)}function aF(e,t){return re(e.getUTCMinutes(),t,2)}function cF(e,t){return re(e.getUTCSeconds(),t,2)}function lF(e){var t=e.getUTCDay();return t===0?7:t}function uF(e,t){return re(Zi.count(In(e)-1,e),t,2)}function ZM(e){var t=e.getUTCDay();return t>=4||t===0?Rr(e):Rr.ceil(e)}function fF(e,t){return e=ZM(e),re(Rr.count(In(e),e)+(In(e).getUTCDay()===4),t,2)}function hF(e){return e.getUTCDay()}function dF(e,t){return re(Ks.count(In(e)-1,e),t,2)}function pF(e,t){return re(e.getUTCFullYear()%100,t,2)}function mF(e,t){return e=ZM(e),re(e.getUTCFullYear()%100,t,2)}function gF(e,t){return re(e.getUTCFullYear()%1e4,t,4)}function _F(e,t){var n=e.getUTCDay();return e=n>=4||n===0?Rr(e):Rr.ceil(e),re(e.getUTCFullYear()%1e4,t,4)}function yF(){return"+0000"}function HM(){return"%"}function WM(e){return+e}function $M(e){return Math.floor(+e/1e3)}var da,ol,xF,Ji,JM;vF({dateTime:"%x, %X",date:"%-m/%-d/%Y",time:"%-I:%M:%S %p",periods:["AM","PM"],days:["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"],shortDays:["Sun","Mon","Tue","Wed","Thu","Fri","Sat"],months:["January","February","March","April","May","June","July","August","September","October","November","December"],shortMonths:["Jan","Feb","Mar","Apr","May","Jun","Jul","Aug","Sep","Oct","Nov","Dec"]});function vF(e){return da=xU(e),ol=da.format,xF=da.parse,Ji=da.utcFormat,JM=da.utcParse,da}var KM="%Y-%m-%dT%H:%M:%S.%LZ";function bF(e){return e.toISOString()}var Pz=Date.prototype.toISOString?bF:Ji(KM);function MF(e){var t=new Date(e);return isNaN(t)?null:t}var Iz=+new Date("2000-01-01T00:00:00.000Z")?MF:JM(KM);function Ki(e,t){switch(arguments.length){case 0:break;case 1:this.range(e);break;default:this.range(t).domain(e);break}return this}function wh(e,t){switch(arguments.length){case 0:break;case 1:{typeof e=="function"?this.interpolator(e):this.range(e);break}default:{this.domain(e),typeof t=="function"?this.interpolator(t):this.range(t);break}}return this}var Sh=Symbol("implicit");function Th(){var e=new ti,t=[],n=[],i=Sh;function r(s){let o=e.get(s);if(o===void 0){if(i!==Sh)return i;e.set(s,o=t.push(s)-1)}return n[o%n.length]}return r.domain=function(s){if(!arguments.length)return t.slice();t=[],e=new ti;for(let o of s)e.has(o)||e.set(o,t.push(o)-1);return r},r.range=function(s){return arguments.length?(n=Array.from(s),r):n.slice()},r.unknown=function(s){return arguments.length?(i=s,r):i},r.copy=function(){return Th(t,n).unknown(i)},Ki.apply(r,arguments),r}function pa(){var e=Th().unknown(void 0),t=e.domain,n=e.range,i=0,r=1,s,o,a=!1,c=0,l=0,u=.5;delete e.unknown;function h(){var f=t().length,d=r<i,p=d?r:i,_=d?i:r;s=(_-p)/Math.max(1,f-c+l*2),a&&(s=Math.floor(s)),p+=(_-p-s*(f-c))*u,o=s*(1-c),a&&(p=Math.round(p),o=Math.round(o));var g=Ko(f).map(function(m){return p+s*m});return n(d?g.reverse():g)}return e.domain=function(f){return arguments.length?(t(f),h()):t()},e.range=function(f){return arguments.length?([i,r]=f,i=+i,r=+r,h()):[i,r]},e.rangeRound=function(f){return[i,r]=f,i=+i,r=+r,a=!0,h()},e.bandwidth=function(){return o},e.step=function(){return s},e.round=function(f){return arguments.length?(a=!!f,h()):a},e.padding=function(f){return arguments.length?(c=Math.min(1,l=+f),h()):c},e.paddingInner=function(f){return arguments.length?(c=Math.min(1,f),h()):c},e.paddingOuter=function(f){return arguments.length?(l=+f,h()):l},e.align=function(f){return arguments.length?(u=Math.max(0,Math.min(1,f)),h()):u},e.copy=function(){return pa(t(),[i,r]).round(a).paddingInner(c).paddingOuter(l).align(u)},Ki.apply(h(),arguments)}function sS(e){var t=e.copy;return e.padding=e.paddingOuter,delete e.paddingInner,delete e.paddingOuter,e.copy=function(){return sS(t())},e}function oS(){return sS(pa.apply(null,arguments).paddingInner(1))}function SF(e){return function(){return e}}function vg(e){return+e}var jM=[0,1];function li(e){return e}function bg(e,t){return(t-=e=+e)?function(n){return(n-e)/t}:SF(isNaN(t)?NaN:.5)}function wF(e,t){var n;return e>t&&(n=e,e=t,t=n),function(i){return Math.max(e,Math.min(t,i))}}function TF(e,t,n){var i=e[0],r=e[1],s=t[0],o=t[1];return r<i?(i=bg(r,i),s=n(o,s)):(i=bg(i,r),s=n(s,o)),function(a){return s(i(a))}}function AF(e,t,n){var i=Math.min(e.length,t.length)-1,r=new Array(i),s=new Array(i),o=-1;for(e[i]<e[0]&&(e=e.slice().reverse(),t=t.slice().reverse());++o<i;)r[o]=bg(e[o],e[o+1]),s[o]=n(t[o],t[o+1]);return function(a){var c=Bf(e,a,1,i)-1;return s[c](r[c](a))}}function al(e,t){return t.domain(e.domain()).range(e.range()).interpolate(e.interpolate()).clamp(e.clamp()).unknown(e.unknown())}function Ah(){var e=jM,t=jM,n=sa,i,r,s,o=li,a,c,l;function u(){var f=Math.min(e.length,t.length);return o!==li&&(o=wF(e[0],e[f-1])),a=f>2?AF:TF,c=l=null,h}function h(f){return f==null||isNaN(f=+f)?s:(c||(c=a(e.map(i),t,n)))(i(o(f)))}return h.invert=function(f){return o(r((l||(l=a(t,e.map(i),ke)))(f)))},h.domain=function(f){return arguments.length?(e=Array.from(f,vg),u()):e.slice()},h.range=function(f){return arguments.length?(t=Array.from(f),u()):t.slice()},h.rangeRound=function(f){return t=Array.from(f),n=kc,u()},h.clamp=function(f){return arguments.length?(o=f?!0:li,u()):o!==li},h.interpolate=function(f){return arguments.length?(n=f,u()):n},h.unknown=function(f){return arguments.length?(s=f,h):s},function(f,d){return i=f,r=d,u()}}function aS(){return Ah()(li,li)}function EF(e,t,n,i){var r=Dc(e,t,n),s;switch(i=aa(i??",f"),i.type){case"s":{var o=Math.max(Math.abs(e),Math.abs(t));return i.precision==null&&!isNaN(s=b1(r,o))&&(i.precision=s),Nm(i,o)}case"":case"e":case"g":case"p":case"r":{i.precision==null&&!isNaN(s=M1(r,Math.max(Math.abs(e),Math.abs(t))))&&(i.precision=s-(i.type==="e"));break}case"f":case"%":{i.precision==null&&!isNaN(s=v1(r))&&(i.precision=s-(i.type==="%")*2);break}}return Wi(i)}function cl(e){var t=e.domain;return e.ticks=function(n){var i=t();return Jo(i[0],i[i.length-1],n??10)},e.tickFormat=function(n,i){var r=t();return EF(r[0],r[r.length-1],n??10,i)},e.nice=function(n){n==null&&(n=10);var i=t(),r=0,s=i.length-1,o=i[r],a=i[s],c,l,u=10;for(a<o&&(l=o,o=a,a=l,l=r,r=s,s=l);u-- >0;){if(l=Of(o,a,n),l===c)return i[r]=o,i[s]=a,t(i);if(l>0)o=Math.floor(o/l)*l,a=Math.ceil(a/l)*l;else if(l<0)o=Math.ceil(o*l)/l,a=Math.floor(a*l)/l;else break;c=l}return e},e}function ll(){var e=aS();return e.copy=function(){return al(e,ll())},Ki.apply(e,arguments),cl(e)}function Mg(e){var t;function n(i){return i==null||isNaN(i=+i)?t:i}return n.invert=n,n.domain=n.range=function(i){return arguments.length?(e=Array.from(i,vg),n):e.slice()},n.unknown=function(i){return arguments.length?(t=i,n):t},n.copy=function(){return Mg(e).unknown(t)},e=arguments.length?Array.from(e,vg):[0,1],cl(n)}function cS(e,t){e=e.slice();var n=0,i=e.length-1,r=e[n],s=e[i],o;return s<r&&(o=n,n=i,i=o,o=r,r=s,s=o),e[n]=t.floor(r),e[i]=t.ceil(s),e}function QM(e){return Math.log(e)}function tS(e){return Math.exp(e)}function CF(e){return-Math.log(-e)}function RF(e){return-Math.exp(-e)}function PF(e){return isFinite(e)?+("1e"+e):e<0?0:e}function IF(e){return e===10?PF:e===Math.E?Math.exp:t=>Math.pow(e,t)}function LF(e){return e===Math.E?Math.log:e===10&&Math.log10||e===2&&Math.log2||(e=Math.log(e),t=>Math.log(t)/e)}function eS(e){return(t,n)=>-e(-t,n)}function lS(e){let t=e(QM,tS),n=t.domain,i=10,r,s;function o(){return r=LF(i),s=IF(i),n()[0]<0?(r=eS(r),s=eS(s),e(CF,RF)):e(QM,tS),t}return t.base=function(a){return arguments.length?(i=+a,o()):i},t.domain=function(a){return arguments.length?(n(a),o()):n()},t.ticks=a=>{let c=n(),l=c[0],u=c[c.length-1],h=u<l;h&&([l,u]=[u,l]);let f=r(l),d=r(u),p,_,g=a==null?10:+a,m=[];if(!(i%1)&&d-f<g){if(f=Math.floor(f),d=Math.ceil(d),l>0){for(;f<=d;++f)for(p=1;p<i;++p)if(_=f<0?p/s(-f):p*s(f),!(_<l)){if(_>u)break;m.push(_)}}else for(;f<=d;++f)for(p=i-1;p>=1;--p)if(_=f>0?p/s(-f):p*s(f),!(_<l)){if(_>u)break;m.push(_)}m.length*2<g&&(m=Jo(l,u,g))}else m=Jo(f,d,Math.min(d-f,g)).map(s);return h?m.reverse():m},t.tickFormat=(a,c)=>{if(a==null&&(a=10),c==null&&(c=i===10?"s":","),typeof c!="function"&&(!(i%1)&&(c=aa(c)).precision==null&&(c.trim=!0),c=Wi(c)),a===1/0)return c;let l=Math.max(1,i*a/t.ticks().length);return u=>{let h=u/s(Math.round(r(u)));return h*i<i-.5&&(h*=i),h<=l?c(u):""}},t.nice=()=>n(cS(n(),{floor:a=>s(Math.floor(r(a))),ceil:a=>s(Math.ceil(r(a)))})),t}function Sg(){let e=lS(Ah()).domain([1,10]);return e.copy=()=>al(e,Sg()).base(e.base()),Ki.apply(e,arguments),e}function nS(e){return function(t){return Math.sign(t)*Math.log1p(Math.abs(t/e))}}function iS(e){return function(t){return Math.sign(t)*Math.expm1(Math.abs(t))*e}}function uS(e){var t=1,n=e(nS(t),iS(t));return n.constant=function(i){return arguments.length?e(nS(t=+i),iS(t)):t},cl(n)}function wg(){var e=uS(Ah());return e.copy=function(){return al(e,wg()).constant(e.constant())},Ki.apply(e,arguments)}function rS(e){return function(t){return t<0?-Math.pow(-t,e):Math.pow(t,e)}}function NF(e){return e<0?-Math.sqrt(-e):Math.sqrt(e)}function DF(e){return e<0?-e*e:e*e}function fS(e){var t=e(li,li),n=1;function i(){return n===1?e(li,li):n===.5?e(NF,DF):e(rS(n),rS(1/n))}return t.exponent=function(r){return arguments.length?(n=+r,i()):n},cl(t)}function Tg(){var e=fS(Ah());return e.copy=function(){return al(e,Tg()).exponent(e.exponent())},Ki.apply(e,arguments),e}function Ag(){var e=[],t=[],n=[],i;function r(){var o=0,a=Math.max(1,t.length);for(n=new Array(a-1);++o<a;)n[o-1]=db(e,o/a);return s}function s(o){return o==null||isNaN(o=+o)?i:t[Bf(n,o)]}return s.invertExtent=function(o){var a=t.indexOf(o);return a<0?[NaN,NaN]:[a>0?n[a-1]:e[0],a<n.length?n[a]:e[e.length-1]]},s.domain=function(o){if(!arguments.length)return e.slice();e=[];for(let a of o)a!=null&&!isNaN(a=+a)&&e.push(a);return e.sort(gn),r()},s.range=function(o){return arguments.length?(t=Array.from(o),r()):t.slice()},s.unknown=function(o){return arguments.length?(i=o,s):i},s.quantiles=function(){return n.slice()},s.copy=function(){return Ag().domain(e).range(t).unknown(i)},Ki.apply(s,arguments)}function Eg(){var e=[.5],t=[0,1],n,i=1;function r(s){return s!=null&&s<=s?t[Bf(e,s,0,i)]:n}return r.domain=function(s){return arguments.length?(e=Array.from(s),i=Math.min(e.length,t.length-1),r):e.slice()},r.range=function(s){return arguments.length?(t=Array.from(s),i=Math.min(e.length,t.length-1),r):t.slice()},r.invertExtent=function(s){var o=t.indexOf(s);return[e[o-1],e[o]]},r.unknown=function(s){return arguments.length?(n=s,r):n},r.copy=function(){return Eg().domain(e).range(t).unknown(n)},Ki.apply(r,arguments)}function UF(e){return new Date(e)}function FF(e){return e instanceof Date?+e:Math.round(e)}function Cg(e,t,n,i,r,s,o,a,c,l){var u=aS(),h=u.invert,f=u.domain,d=l(".%L"),p=l(":%S"),_=l("%I:%M"),g=l("%I %p"),m=l("%a %d"),x=l("%b %d"),S=l("%B"),v=l("%Y");function w(b){return(c(b)<b?d:a(b)<b?p:o(b)<b?_:s(b)<b?g:i(b)<b?r(b)<b?m:x:n(b)<b?S:v)(b)}return u.invert=function(b){return new Date(Math.round(h(b)))},u.domain=function(b){return arguments.length?f(Array.from(b,FF)):f().map(UF)},u.ticks=function(b){var y=f();return e(y[0],y[y.length-1],b??10)},u.tickFormat=function(b,y){return y==null?w:l(y)},u.nice=function(b){var y=f();return(!b||typeof b.range!="function")&&(b=t(y[0],y[y.length-1],b??10)),b?f(cS(y,b)):u},u.copy=function(){return al(u,Cg(e,t,n,i,r,s,o,a,c,l))},u}function hS(){return Ki.apply(Cg(DM,UM,Pn,js,Yi,qi,Xs,Ws,wn,ol).domain([new Date(2e3,0,1),new Date(2e3,0,2)]),arguments)}function dS(){return Ki.apply(Cg(LM,NM,In,Qs,Zi,ha,qs,$s,wn,Ji).domain([Date.UTC(2e3,0,1),Date.UTC(2e3,0,2)]),arguments)}function Eh(e,t){return t.domain(e.domain()).interpolator(e.interpolator()).clamp(e.clamp()).unknown(e.unknown())}function Ch(){var e=0,t=.5,n=1,i=1,r,s,o,a,c,l=li,u,h=!1,f;function d(_){return _==null||isNaN(_=+_)?f:(_=.5+((_=+u(_))-s)*(i*_<i*s?a:c),l(h?Math.max(0,Math.min(1,_)):_))}d.domain=function(_){return arguments.length?([e,t,n]=_,r=u(e=+e),s=u(t=+t),o=u(n=+n),a=r===s?0:.5/(s-r),c=s===o?0:.5/(o-s),i=s<r?-1:1,d):[e,t,n]},d.clamp=function(_){return arguments.length?(h=!!_,d):h},d.interpolator=function(_){return arguments.length?(l=_,d):l};function p(_){return function(g){var m,x,S;return arguments.length?([m,x,S]=g,l=os(_,[m,x,S]),d):[l(0),l(.5),l(1)]}}return d.range=p(sa),d.rangeRound=p(kc),d.unknown=function(_){return arguments.length?(f=_,d):f},function(_){return u=_,r=_(e),s=_(t),o=_(n),a=r===s?0:.5/(s-r),c=s===o?0:.5/(o-s),i=s<r?-1:1,d}}function Rg(){var e=cl(Ch()(li));return e.copy=function(){return Eh(e,Rg())},wh.apply(e,arguments)}function Pg(){var e=lS(Ch()).domain([.1,1,10]);return e.copy=function(){return Eh(e,Pg()).base(e.base())},wh.apply(e,arguments)}function Ig(){var e=uS(Ch());return e.copy=function(){return Eh(e,Ig()).constant(e.constant())},wh.apply(e,arguments)}function Lg(){var e=fS(Ch());return e.copy=function(){return Eh(e,Lg()).exponent(e.exponent())},wh.apply(e,arguments)}function $t(e){for(var t=e.length/6|0,n=new Array(t),i=0;i<t;)n[i]="#"+e.slice(i*6,++i*6);return n}var pS=$t("1f77b4ff7f0e2ca02cd627289467bd8c564be377c27f7f7fbcbd2217becf"),mS=$t("7fc97fbeaed4fdc086ffff99386cb0f0027fbf5b17666666"),gS=$t("1b9e77d95f027570b3e7298a66a61ee6ab02a6761d666666"),_S=$t("4269d0efb118ff725c6cc5b03ca951ff8ab7a463f297bbf59c6b4e9498a0"),yS=$t("a6cee31f78b4b2df8a33a02cfb9a99e31a1cfdbf6fff7f00cab2d66a3d9affff99b15928"),xS=$t("fbb4aeb3cde3ccebc5decbe4fed9a6ffffcce5d8bdfddaecf2f2f2"),vS=$t("b3e2cdfdcdaccbd5e8f4cae4e6f5c9fff2aef1e2cccccccc"),bS=$t("e41a1c377eb84daf4a984ea3ff7f00ffff33a65628f781bf999999"),MS=$t("66c2a5fc8d628da0cbe78ac3a6d854ffd92fe5c494b3b3b3"),SS=$t("8dd3c7ffffb3bebadafb807280b1d3fdb462b3de69fccde5d9d9d9bc80bdccebc5ffed6f"),wS=$t("4e79a7f28e2ce1575976b7b259a14fedc949af7aa1ff9da79c755fbab0ab"),ge=e=>r1(e[e.length-1]),Ng=new Array(3).concat("d8b365f5f5f55ab4ac","a6611adfc27d80cdc1018571","a6611adfc27df5f5f580cdc1018571","8c510ad8b365f6e8c3c7eae55ab4ac01665e","8c510ad8b365f6e8c3f5f5f5c7eae55ab4ac01665e","8c510abf812ddfc27df6e8c3c7eae580cdc135978f01665e","8c510abf812ddfc27df6e8c3f5f5f5c7eae580cdc135978f01665e","5430058c510abf812ddfc27df6e8c3c7eae580cdc135978f01665e003c30","5430058c510abf812ddfc27df6e8c3f5f5f5c7eae580cdc135978f01665e003c30").map($t),Dg=ge(Ng),Ug=new Array(3).concat("af8dc3f7f7f77fbf7b","7b3294c2a5cfa6dba0008837","7b3294c2a5cff7f7f7a6dba0008837","762a83af8dc3e7d4e8d9f0d37fbf7b1b7837","762a83af8dc3e7d4e8f7f7f7d9f0d37fbf7b1b7837","762a839970abc2a5cfe7d4e8d9f0d3a6dba05aae611b7837","762a839970abc2a5cfe7d4e8f7f7f7d9f0d3a6dba05aae611b7837","40004b762a839970abc2a5cfe7d4e8d9f0d3a6dba05aae611b783700441b","40004b762a839970abc2a5cfe7d4e8f7f7f7d9f0d3a6dba05aae611b783700441b").map($t),Fg=ge(Ug),Og=new Array(3).concat("e9a3c9f7f7f7a1d76a","d01c8bf1b6dab8e1864dac26","d01c8bf1b6daf7f7f7b8e1864dac26","c51b7de9a3c9fde0efe6f5d0a1d76a4d9221","c51b7de9a3c9fde0eff7f7f7e6f5d0a1d76a4d9221","c51b7dde77aef1b6dafde0efe6f5d0b8e1867fbc414d9221","c51b7dde77aef1b6dafde0eff7f7f7e6f5d0b8e1867fbc414d9221","8e0152c51b7dde77aef1b6dafde0efe6f5d0b8e1867fbc414d9221276419","8e0152c51b7dde77aef1b6dafde0eff7f7f7e6f5d0b8e1867fbc414d9221276419").map($t),Bg=ge(Og),kg=new Array(3).concat("998ec3f7f7f7f1a340","5e3c99b2abd2fdb863e66101","5e3c99b2abd2f7f7f7fdb863e66101","542788998ec3d8daebfee0b6f1a340b35806","542788998ec3d8daebf7f7f7fee0b6f1a340b35806","5427888073acb2abd2d8daebfee0b6fdb863e08214b35806","5427888073acb2abd2d8daebf7f7f7fee0b6fdb863e08214b35806","2d004b5427888073acb2abd2d8daebfee0b6fdb863e08214b358067f3b08","2d004b5427888073acb2abd2d8daebf7f7f7fee0b6fdb863e08214b358067f3b08").map($t),zg=ge(kg),Ih=new Array(3).concat("ef8a62f7f7f767a9cf","ca0020f4a58292c5de0571b0","ca0020f4a582f7f7f792c5de0571b0","b2182bef8a62fddbc7d1e5f067a9cf2166ac","b2182bef8a62fddbc7f7f7f7d1e5f067a9cf2166ac","b2182bd6604df4a582fddbc7d1e5f092c5de4393c32166ac","b2182bd6604df4a582fddbc7f7f7f7d1e5f092c5de4393c32166ac","67001fb2182bd6604df4a582fddbc7d1e5f092c5de4393c32166ac053061","67001fb2182bd6604df4a582fddbc7f7f7f7d1e5f092c5de4393c32166ac053061").map($t),ul=ge(Ih),Gg=new Array(3).concat("ef8a62ffffff999999","ca0020f4a582bababa404040","ca0020f4a582ffffffbababa404040","b2182bef8a62fddbc7e0e0e09999994d4d4d","b2182bef8a62fddbc7ffffffe0e0e09999994d4d4d","b2182bd6604df4a582fddbc7e0e0e0bababa8787874d4d4d","b2182bd6604df4a582fddbc7ffffffe0e0e0bababa8787874d4d4d","67001fb2182bd6604df4a582fddbc7e0e0e0bababa8787874d4d4d1a1a1a","67001fb2182bd6604df4a582fddbc7ffffffe0e0e0bababa8787874d4d4d1a1a1a").map($t),Vg=ge(Gg),Lh=new Array(3).concat("fc8d59ffffbf91bfdb","d7191cfdae61abd9e92c7bb6","d7191cfdae61ffffbfabd9e92c7bb6","d73027fc8d59fee090e0f3f891bfdb4575b4","d73027fc8d59fee090ffffbfe0f3f891bfdb4575b4","d73027f46d43fdae61fee090e0f3f8abd9e974add14575b4","d73027f46d43fdae61fee090ffffbfe0f3f8abd9e974add14575b4","a50026d73027f46d43fdae61fee090e0f3f8abd9e974add14575b4313695","a50026d73027f46d43fdae61fee090ffffbfe0f3f8abd9e974add14575b4313695").map($t),fl=ge(Lh),Hg=new Array(3).concat("fc8d59ffffbf91cf60","d7191cfdae61a6d96a1a9641","d7191cfdae61ffffbfa6d96a1a9641","d73027fc8d59fee08bd9ef8b91cf601a9850","d73027fc8d59fee08bffffbfd9ef8b91cf601a9850","d73027f46d43fdae61fee08bd9ef8ba6d96a66bd631a9850","d73027f46d43fdae61fee08bffffbfd9ef8ba6d96a66bd631a9850","a50026d73027f46d43fdae61fee08bd9ef8ba6d96a66bd631a9850006837","a50026d73027f46d43fdae61fee08bffffbfd9ef8ba6d96a66bd631a9850006837").map($t),Wg=ge(Hg),$g=new Array(3).concat("fc8d59ffffbf99d594","d7191cfdae61abdda42b83ba","d7191cfdae61ffffbfabdda42b83ba","d53e4ffc8d59fee08be6f59899d5943288bd","d53e4ffc8d59fee08bffffbfe6f59899d5943288bd","d53e4ff46d43fdae61fee08be6f598abdda466c2a53288bd","d53e4ff46d43fdae61fee08bffffbfe6f598abdda466c2a53288bd","9e0142d53e4ff46d43fdae61fee08be6f598abdda466c2a53288bd5e4fa2","9e0142d53e4ff46d43fdae61fee08bffffbfe6f598abdda466c2a53288bd5e4fa2").map($t),Xg=ge($g),qg=new Array(3).concat("e5f5f999d8c92ca25f","edf8fbb2e2e266c2a4238b45","edf8fbb2e2e266c2a42ca25f006d2c","edf8fbccece699d8c966c2a42ca25f006d2c","edf8fbccece699d8c966c2a441ae76238b45005824","f7fcfde5f5f9ccece699d8c966c2a441ae76238b45005824","f7fcfde5f5f9ccece699d8c966c2a441ae76238b45006d2c00441b").map($t),Yg=ge(qg),Zg=new Array(3).concat("e0ecf49ebcda8856a7","edf8fbb3cde38c96c688419d","edf8fbb3cde38c96c68856a7810f7c","edf8fbbfd3e69ebcda8c96c68856a7810f7c","edf8fbbfd3e69ebcda8c96c68c6bb188419d6e016b","f7fcfde0ecf4bfd3e69ebcda8c96c68c6bb188419d6e016b","f7fcfde0ecf4bfd3e69ebcda8c96c68c6bb188419d810f7c4d004b").map($t),Jg=ge(Zg),Kg=new Array(3).concat("e0f3dba8ddb543a2ca","f0f9e8bae4bc7bccc42b8cbe","f0f9e8bae4bc7bccc443a2ca0868ac","f0f9e8ccebc5a8ddb57bccc443a2ca0868ac","f0f9e8ccebc5a8ddb57bccc44eb3d32b8cbe08589e","f7fcf0e0f3dbccebc5a8ddb57bccc44eb3d32b8cbe08589e","f7fcf0e0f3dbccebc5a8ddb57bccc44eb3d32b8cbe0868ac084081").map($t),jg=ge(Kg),Qg=new Array(3).concat("fee8c8fdbb84e34a33","fef0d9fdcc8afc8d59d7301f","fef0d9fdcc8afc8d59e34a33b30000","fef0d9fdd49efdbb84fc8d59e34a33b30000","fef0d9fdd49efdbb84fc8d59ef6548d7301f990000","fff7ecfee8c8fdd49efdbb84fc8d59ef6548d7301f990000","fff7ecfee8c8fdd49efdbb84fc8d59ef6548d7301fb300007f0000").map($t),t0=ge(Qg),e0=new Array(3).concat("ece2f0a6bddb1c9099","f6eff7bdc9e167a9cf02818a","f6eff7bdc9e167a9cf1c9099016c59","f6eff7d0d1e6a6bddb67a9cf1c9099016c59","f6eff7d0d1e6a6bddb67a9cf3690c002818a016450","fff7fbece2f0d0d1e6a6bddb67a9cf3690c002818a016450","fff7fbece2f0d0d1e6a6bddb67a9cf3690c002818a016c59014636").map($t),n0=ge(e0),i0=new Array(3).concat("ece7f2a6bddb2b8cbe","f1eef6bdc9e174a9cf0570b0","f1eef6bdc9e174a9cf2b8cbe045a8d","f1eef6d0d1e6a6bddb74a9cf2b8cbe045a8d","f1eef6d0d1e6a6bddb74a9cf3690c00570b0034e7b","fff7fbece7f2d0d1e6a6bddb74a9cf3690c00570b0034e7b","fff7fbece7f2d0d1e6a6bddb74a9cf3690c00570b0045a8d023858").map($t),r0=ge(i0),s0=new Array(3).concat("e7e1efc994c7dd1c77","f1eef6d7b5d8df65b0ce1256","f1eef6d7b5d8df65b0dd1c77980043","f1eef6d4b9dac994c7df65b0dd1c77980043","f1eef6d4b9dac994c7df65b0e7298ace125691003f","f7f4f9e7e1efd4b9dac994c7df65b0e7298ace125691003f","f7f4f9e7e1efd4b9dac994c7df65b0e7298ace125698004367001f").map($t),o0=ge(s0),a0=new Array(3).concat("fde0ddfa9fb5c51b8a","feebe2fbb4b9f768a1ae017e","feebe2fbb4b9f768a1c51b8a7a0177","feebe2fcc5c0fa9fb5f768a1c51b8a7a0177","feebe2fcc5c0fa9fb5f768a1dd3497ae017e7a0177","fff7f3fde0ddfcc5c0fa9fb5f768a1dd3497ae017e7a0177","fff7f3fde0ddfcc5c0fa9fb5f768a1dd3497ae017e7a017749006a").map($t),c0=ge(a0),l0=new Array(3).concat("edf8b17fcdbb2c7fb8","ffffcca1dab441b6c4225ea8","ffffcca1dab441b6c42c7fb8253494","ffffccc7e9b47fcdbb41b6c42c7fb8253494","ffffccc7e9b47fcdbb41b6c41d91c0225ea80c2c84","ffffd9edf8b1c7e9b47fcdbb41b6c41d91c0225ea80c2c84","ffffd9edf8b1c7e9b47fcdbb41b6c41d91c0225ea8253494081d58").map($t),u0=ge(l0),f0=new Array(3).concat("f7fcb9addd8e31a354","ffffccc2e69978c679238443","ffffccc2e69978c67931a354006837","ffffccd9f0a3addd8e78c67931a354006837","ffffccd9f0a3addd8e78c67941ab5d238443005a32","ffffe5f7fcb9d9f0a3addd8e78c67941ab5d238443005a32","ffffe5f7fcb9d9f0a3addd8e78c67941ab5d238443006837004529").map($t),h0=ge(f0),d0=new Array(3).concat("fff7bcfec44fd95f0e","ffffd4fed98efe9929cc4c02","ffffd4fed98efe9929d95f0e993404","ffffd4fee391fec44ffe9929d95f0e993404","ffffd4fee391fec44ffe9929ec7014cc4c028c2d04","ffffe5fff7bcfee391fec44ffe9929ec7014cc4c028c2d04","ffffe5fff7bcfee391fec44ffe9929ec7014cc4c02993404662506").map($t),p0=ge(d0),m0=new Array(3).concat("ffeda0feb24cf03b20","ffffb2fecc5cfd8d3ce31a1c","ffffb2fecc5cfd8d3cf03b20bd0026","ffffb2fed976feb24cfd8d3cf03b20bd0026","ffffb2fed976feb24cfd8d3cfc4e2ae31a1cb10026","ffffccffeda0fed976feb24cfd8d3cfc4e2ae31a1cb10026","ffffccffeda0fed976feb24cfd8d3cfc4e2ae31a1cbd0026800026").map($t),g0=ge(m0),_0=new Array(3).concat("deebf79ecae13182bd","eff3ffbdd7e76baed62171b5","eff3ffbdd7e76baed63182bd08519c","eff3ffc6dbef9ecae16baed63182bd08519c","eff3ffc6dbef9ecae16baed64292c62171b5084594","f7fbffdeebf7c6dbef9ecae16baed64292c62171b5084594","f7fbffdeebf7c6dbef9ecae16baed64292c62171b508519c08306b").map($t),y0=ge(_0),x0=new Array(3).concat("e5f5e0a1d99b31a354","edf8e9bae4b374c476238b45","edf8e9bae4b374c47631a354006d2c","edf8e9c7e9c0a1d99b74c47631a354006d2c","edf8e9c7e9c0a1d99b74c47641ab5d238b45005a32","f7fcf5e5f5e0c7e9c0a1d99b74c47641ab5d238b45005a32","f7fcf5e5f5e0c7e9c0a1d99b74c47641ab5d238b45006d2c00441b").map($t),v0=ge(x0),b0=new Array(3).concat("f0f0f0bdbdbd636363","f7f7f7cccccc969696525252","f7f7f7cccccc969696636363252525","f7f7f7d9d9d9bdbdbd969696636363252525","f7f7f7d9d9d9bdbdbd969696737373525252252525","fffffff0f0f0d9d9d9bdbdbd969696737373525252252525","fffffff0f0f0d9d9d9bdbdbd969696737373525252252525000000").map($t),M0=ge(b0),S0=new Array(3).concat("efedf5bcbddc756bb1","f2f0f7cbc9e29e9ac86a51a3","f2f0f7cbc9e29e9ac8756bb154278f","f2f0f7dadaebbcbddc9e9ac8756bb154278f","f2f0f7dadaebbcbddc9e9ac8807dba6a51a34a1486","fcfbfdefedf5dadaebbcbddc9e9ac8807dba6a51a34a1486","fcfbfdefedf5dadaebbcbddc9e9ac8807dba6a51a354278f3f007d").map($t),w0=ge(S0),T0=new Array(3).concat("fee0d2fc9272de2d26","fee5d9fcae91fb6a4acb181d","fee5d9fcae91fb6a4ade2d26a50f15","fee5d9fcbba1fc9272fb6a4ade2d26a50f15","fee5d9fcbba1fc9272fb6a4aef3b2ccb181d99000d","fff5f0fee0d2fcbba1fc9272fb6a4aef3b2ccb181d99000d","fff5f0fee0d2fcbba1fc9272fb6a4aef3b2ccb181da50f1567000d").map($t),A0=ge(T0),E0=new Array(3).concat("fee6cefdae6be6550d","feeddefdbe85fd8d3cd94701","feeddefdbe85fd8d3ce6550da63603","feeddefdd0a2fdae6bfd8d3ce6550da63603","feeddefdd0a2fdae6bfd8d3cf16913d948018c2d04","fff5ebfee6cefdd0a2fdae6bfd8d3cf16913d948018c2d04","fff5ebfee6cefdd0a2fdae6bfd8d3cf16913d94801a636037f2704").map($t),C0=ge(E0);function R0(e){return e=Math.max(0,Math.min(1,e)),"rgb("+Math.max(0,Math.min(255,Math.round(-4.54-e*(35.34-e*(2381.73-e*(6402.7-e*(7024.72-e*2710.57)))))))+", "+Math.max(0,Math.min(255,Math.round(32.49+e*(170.73+e*(52.82-e*(131.46-e*(176.58-e*67.37)))))))+", "+Math.max(0,Math.min(255,Math.round(81.24+e*(442.36-e*(2482.43-e*(6167.24-e*(6614.94-e*2475.67)))))))+")"}var P0=jf(ii(300,.5,0),ii(-240,.5,1)),I0=jf(ii(-100,.75,.35),ii(80,1.5,.8)),L0=jf(ii(260,.75,.35),ii(80,1.5,.8)),Rh=ii();function N0(e){(e<0||e>1)&&(e-=Math.floor(e));var t=Math.abs(e-.5);return Rh.h=360*e-100,Rh.s=1.5-1.5*t,Rh.l=.8-.9*t,Rh+""}var Ph=Ei(),OF=Math.PI/3,BF=Math.PI*2/3;function D0(e){var t;return e=(.5-e)*Math.PI,Ph.r=255*(t=Math.sin(e))*t,Ph.g=255*(t=Math.sin(e+OF))*t,Ph.b=255*(t=Math.sin(e+BF))*t,Ph+""}function U0(e){return e=Math.max(0,Math.min(1,e)),"rgb("+Math.max(0,Math.min(255,Math.round(34.61+e*(1172.33-e*(10793.56-e*(33300.12-e*(38394.49-e*14825.05)))))))+", "+Math.max(0,Math.min(255,Math.round(23.31+e*(557.33+e*(1225.33-e*(3574.96-e*(1073.77+e*707.56)))))))+", "+Math.max(0,Math.min(255,Math.round(27.2+e*(3211.1-e*(15327.97-e*(27814-e*(22569.18-e*6838.66)))))))+")"}function Nh(e){var t=e.length;return function(n){return e[Math.max(0,Math.min(t-1,Math.floor(n*t)))]}}var F0=Nh($t("44015444025645045745055946075a46085c460a5d460b5e470d60470e6147106347116447136548146748166848176948186a481a6c481b6d481c6e481d6f481f70482071482173482374482475482576482677482878482979472a7a472c7a472d7b472e7c472f7d46307e46327e46337f463480453581453781453882443983443a83443b84433d84433e85423f854240864241864142874144874045884046883f47883f48893e49893e4a893e4c8a3d4d8a3d4e8a3c4f8a3c508b3b518b3b528b3a538b3a548c39558c39568c38588c38598c375a8c375b8d365c8d365d8d355e8d355f8d34608d34618d33628d33638d32648e32658e31668e31678e31688e30698e306a8e2f6b8e2f6c8e2e6d8e2e6e8e2e6f8e2d708e2d718e2c718e2c728e2c738e2b748e2b758e2a768e2a778e2a788e29798e297a8e297b8e287c8e287d8e277e8e277f8e27808e26818e26828e26828e25838e25848e25858e24868e24878e23888e23898e238a8d228b8d228c8d228d8d218e8d218f8d21908d21918c20928c20928c20938c1f948c1f958b1f968b1f978b1f988b1f998a1f9a8a1e9b8a1e9c891e9d891f9e891f9f881fa0881fa1881fa1871fa28720a38620a48621a58521a68522a78522a88423a98324aa8325ab8225ac8226ad8127ad8128ae8029af7f2ab07f2cb17e2db27d2eb37c2fb47c31b57b32b67a34b67935b77937b87838b9773aba763bbb753dbc743fbc7340bd7242be7144bf7046c06f48c16e4ac16d4cc26c4ec36b50c46a52c56954c56856c66758c7655ac8645cc8635ec96260ca6063cb5f65cb5e67cc5c69cd5b6ccd5a6ece5870cf5773d05675d05477d1537ad1517cd2507fd34e81d34d84d44b86d54989d5488bd6468ed64590d74393d74195d84098d83e9bd93c9dd93ba0da39a2da37a5db36a8db34aadc32addc30b0dd2fb2dd2db5de2bb8de29bade28bddf26c0df25c2df23c5e021c8e020cae11fcde11dd0e11cd2e21bd5e21ad8e219dae319dde318dfe318e2e418e5e419e7e419eae51aece51befe51cf1e51df4e61ef6e620f8e621fbe723fde725")),O0=Nh($t("00000401000501010601010802010902020b02020d03030f03031204041405041606051806051a07061c08071e0907200a08220b09240c09260d0a290e0b2b100b2d110c2f120d31130d34140e36150e38160f3b180f3d19103f1a10421c10441d11471e114920114b21114e22115024125325125527125829115a2a115c2c115f2d11612f116331116533106734106936106b38106c390f6e3b0f703d0f713f0f72400f74420f75440f764510774710784910784a10794c117a4e117b4f127b51127c52137c54137d56147d57157e59157e5a167e5c167f5d177f5f187f601880621980641a80651a80671b80681c816a1c816b1d816d1d816e1e81701f81721f817320817521817621817822817922827b23827c23827e24828025828125818326818426818627818827818928818b29818c29818e2a81902a81912b81932b80942c80962c80982d80992d809b2e7f9c2e7f9e2f7fa02f7fa1307ea3307ea5317ea6317da8327daa337dab337cad347cae347bb0357bb2357bb3367ab5367ab73779b83779ba3878bc3978bd3977bf3a77c03a76c23b75c43c75c53c74c73d73c83e73ca3e72cc3f71cd4071cf4070d0416fd2426fd3436ed5446dd6456cd8456cd9466bdb476adc4869de4968df4a68e04c67e24d66e34e65e44f64e55064e75263e85362e95462ea5661eb5760ec5860ed5a5fee5b5eef5d5ef05f5ef1605df2625df2645cf3655cf4675cf4695cf56b5cf66c5cf66e5cf7705cf7725cf8745cf8765cf9785df9795df97b5dfa7d5efa7f5efa815ffb835ffb8560fb8761fc8961fc8a62fc8c63fc8e64fc9065fd9266fd9467fd9668fd9869fd9a6afd9b6bfe9d6cfe9f6dfea16efea36ffea571fea772fea973feaa74feac76feae77feb078feb27afeb47bfeb67cfeb77efeb97ffebb81febd82febf84fec185fec287fec488fec68afec88cfeca8dfecc8ffecd90fecf92fed194fed395fed597fed799fed89afdda9cfddc9efddea0fde0a1fde2a3fde3a5fde5a7fde7a9fde9aafdebacfcecaefceeb0fcf0b2fcf2b4fcf4b6fcf6b8fcf7b9fcf9bbfcfbbdfcfdbf")),B0=Nh($t("00000401000501010601010802010a02020c02020e03021004031204031405041706041907051b08051d09061f0a07220b07240c08260d08290e092b10092d110a30120a32140b34150b37160b39180c3c190c3e1b0c411c0c431e0c451f0c48210c4a230c4c240c4f260c51280b53290b552b0b572d0b592f0a5b310a5c320a5e340a5f3609613809623909633b09643d09653e0966400a67420a68440a68450a69470b6a490b6a4a0c6b4c0c6b4d0d6c4f0d6c510e6c520e6d540f6d550f6d57106e59106e5a116e5c126e5d126e5f136e61136e62146e64156e65156e67166e69166e6a176e6c186e6d186e6f196e71196e721a6e741a6e751b6e771c6d781c6d7a1d6d7c1d6d7d1e6d7f1e6c801f6c82206c84206b85216b87216b88226a8a226a8c23698d23698f24699025689225689326679526679727669827669a28659b29649d29649f2a63a02a63a22b62a32c61a52c60a62d60a82e5fa92e5eab2f5ead305dae305cb0315bb1325ab3325ab43359b63458b73557b93556ba3655bc3754bd3853bf3952c03a51c13a50c33b4fc43c4ec63d4dc73e4cc83f4bca404acb4149cc4248ce4347cf4446d04545d24644d34743d44842d54a41d74b3fd84c3ed94d3dda4e3cdb503bdd513ade5238df5337e05536e15635e25734e35933e45a31e55c30e65d2fe75e2ee8602de9612bea632aeb6429eb6628ec6726ed6925ee6a24ef6c23ef6e21f06f20f1711ff1731df2741cf3761bf37819f47918f57b17f57d15f67e14f68013f78212f78410f8850ff8870ef8890cf98b0bf98c0af98e09fa9008fa9207fa9407fb9606fb9706fb9906fb9b06fb9d07fc9f07fca108fca309fca50afca60cfca80dfcaa0ffcac11fcae12fcb014fcb216fcb418fbb61afbb81dfbba1ffbbc21fbbe23fac026fac228fac42afac62df9c72ff9c932f9cb35f8cd37f8cf3af7d13df7d340f6d543f6d746f5d949f5db4cf4dd4ff4df53f4e156f3e35af3e55df2e661f2e865f2ea69f1ec6df1ed71f1ef75f1f179f2f27df2f482f3f586f3f68af4f88ef5f992f6fa96f8fb9af9fc9dfafda1fcffa4")),k0=Nh($t("0d088710078813078916078a19068c1b068d1d068e20068f2206902406912605912805922a05932c05942e05952f059631059733059735049837049938049a3a049a3c049b3e049c3f049c41049d43039e44039e46039f48039f4903a04b03a14c02a14e02a25002a25102a35302a35502a45601a45801a45901a55b01a55c01a65e01a66001a66100a76300a76400a76600a76700a86900a86a00a86c00a86e00a86f00a87100a87201a87401a87501a87701a87801a87a02a87b02a87d03a87e03a88004a88104a78305a78405a78606a68707a68808a68a09a58b0aa58d0ba58e0ca48f0da4910ea3920fa39410a29511a19613a19814a099159f9a169f9c179e9d189d9e199da01a9ca11b9ba21d9aa31e9aa51f99a62098a72197a82296aa2395ab2494ac2694ad2793ae2892b02991b12a90b22b8fb32c8eb42e8db52f8cb6308bb7318ab83289ba3388bb3488bc3587bd3786be3885bf3984c03a83c13b82c23c81c33d80c43e7fc5407ec6417dc7427cc8437bc9447aca457acb4679cc4778cc4977cd4a76ce4b75cf4c74d04d73d14e72d24f71d35171d45270d5536fd5546ed6556dd7566cd8576bd9586ada5a6ada5b69db5c68dc5d67dd5e66de5f65de6164df6263e06363e16462e26561e26660e3685fe4695ee56a5de56b5de66c5ce76e5be76f5ae87059e97158e97257ea7457eb7556eb7655ec7754ed7953ed7a52ee7b51ef7c51ef7e50f07f4ff0804ef1814df1834cf2844bf3854bf3874af48849f48948f58b47f58c46f68d45f68f44f79044f79143f79342f89441f89540f9973ff9983ef99a3efa9b3dfa9c3cfa9e3bfb9f3afba139fba238fca338fca537fca636fca835fca934fdab33fdac33fdae32fdaf31fdb130fdb22ffdb42ffdb52efeb72dfeb82cfeba2cfebb2bfebd2afebe2afec029fdc229fdc328fdc527fdc627fdc827fdca26fdcb26fccd25fcce25fcd025fcd225fbd324fbd524fbd724fad824fada24f9dc24f9dd25f8df25f8e125f7e225f7e425f6e626f6e826f5e926f5eb27f4ed27f3ee27f3f027f2f227f1f426f1f525f0f724f0f921"));function ma(e){return function(){return e}}var PS=Math.cos;var H0=Math.min,Dh=Math.sin,Ge=Math.sqrt,TS=1e-12,hl=Math.PI,Hz=hl/2,kh=2*hl;function kF(e){let t=3;return e.digits=function(n){if(!arguments.length)return t;if(n==null)t=null;else{let i=Math.floor(n);if(!(i>=0))throw new RangeError(`invalid digits: ${n}`);t=i}return e},()=>new Vs(t)}var Wz=Array.prototype.slice;function zF(e){return typeof e=="object"&&"length"in e?e:Array.from(e)}function IS(e){this._context=e}IS.prototype={areaStart:function(){this._line=0},areaEnd:function(){this._line=NaN},lineStart:function(){this._point=0},lineEnd:function(){(this._line||this._line!==0&&this._point===1)&&this._context.closePath(),this._line=1-this._line},point:function(e,t){switch(e=+e,t=+t,this._point){case 0:this._point=1,this._line?this._context.lineTo(e,t):this._context.moveTo(e,t);break;case 1:this._point=2;default:this._context.lineTo(e,t);break}}};function ga(e){return new IS(e)}function GF(e){return e[0]}function VF(e){return e[1]}function LS(e,t){var n=ma(!0),i=null,r=ga,s=null,o=kF(a);e=typeof e=="function"?e:e===void 0?GF:ma(e),t=typeof t=="function"?t:t===void 0?VF:ma(t);function a(c){var l,u=(c=zF(c)).length,h,f=!1,d;for(i==null&&(s=r(d=o())),l=0;l<=u;++l)!(l<u&&n(h=c[l],l,c))===f&&((f=!f)?s.lineStart():s.lineEnd()),f&&s.point(+e(h,l,c),+t(h,l,c));if(d)return s=null,d+""||null}return a.x=function(c){return arguments.length?(e=typeof c=="function"?c:ma(+c),a):e},a.y=function(c){return arguments.length?(t=typeof c=="function"?c:ma(+c),a):t},a.defined=function(c){return arguments.length?(n=typeof c=="function"?c:ma(!!c),a):n},a.curve=function(c){return arguments.length?(r=c,i!=null&&(s=r(i)),a):r},a.context=function(c){return arguments.length?(c==null?i=s=null:s=r(i=c),a):i},a}var $z=HF(ga);function NS(e){this._curve=e}NS.prototype={areaStart:function(){this._curve.areaStart()},areaEnd:function(){this._curve.areaEnd()},lineStart:function(){this._curve.lineStart()},lineEnd:function(){this._curve.lineEnd()},point:function(e,t){this._curve.point(t*Math.sin(e),t*-Math.cos(e))}};function HF(e){function t(n){return new NS(e(n))}return t._curve=e,t}var Uh=class{constructor(t,n){this._context=t,this._x=n}areaStart(){this._line=0}areaEnd(){this._line=NaN}lineStart(){this._point=0}lineEnd(){(this._line||this._line!==0&&this._point===1)&&this._context.closePath(),this._line=1-this._line}point(t,n){switch(t=+t,n=+n,this._point){case 0:{this._point=1,this._line?this._context.lineTo(t,n):this._context.moveTo(t,n);break}case 1:this._point=2;default:{this._x?this._context.bezierCurveTo(this._x0=(this._x0+t)/2,this._y0,this._x0,n,t,n):this._context.bezierCurveTo(this._x0,this._y0=(this._y0+n)/2,t,this._y0,t,n);break}}this._x0=t,this._y0=n}};function DS(e){return new Uh(e,!0)}function US(e){return new Uh(e,!1)}var WF=Ge(3),W0={draw(e,t){let n=Ge(t+H0(t/28,.75))*.59436,i=n/2,r=i*WF;e.moveTo(0,n),e.lineTo(0,-n),e.moveTo(-r,-i),e.lineTo(r,i),e.moveTo(-r,i),e.lineTo(r,-i)}},to={draw(e,t){let n=Ge(t/hl);e.moveTo(n,0),e.arc(0,0,n,0,kh)}},$0={draw(e,t){let n=Ge(t/5)/2;e.moveTo(-3*n,-n),e.lineTo(-n,-n),e.lineTo(-n,-3*n),e.lineTo(n,-3*n),e.lineTo(n,-n),e.lineTo(3*n,-n),e.lineTo(3*n,n),e.lineTo(n,n),e.lineTo(n,3*n),e.lineTo(-n,3*n),e.lineTo(-n,n),e.lineTo(-3*n,n),e.closePath()}},FS=Ge(1/3),$F=FS*2,X0={draw(e,t){let n=Ge(t/$F),i=n*FS;e.moveTo(0,-n),e.lineTo(i,0),e.lineTo(0,n),e.lineTo(-i,0),e.closePath()}},q0={draw(e,t){let n=Ge(t)*.62625;e.moveTo(0,-n),e.lineTo(n,0),e.lineTo(0,n),e.lineTo(-n,0),e.closePath()}},Y0={draw(e,t){let n=Ge(t-H0(t/7,2))*.87559;e.moveTo(-n,0),e.lineTo(n,0),e.moveTo(0,n),e.lineTo(0,-n)}},Z0={draw(e,t){let n=Ge(t),i=-n/2;e.rect(i,i,n,n)}},J0={draw(e,t){let n=Ge(t)*.4431;e.moveTo(n,n),e.lineTo(n,-n),e.lineTo(-n,-n),e.lineTo(-n,n),e.closePath()}},XF=.8908130915292852,OS=Dh(hl/10)/Dh(7*hl/10),qF=Dh(kh/10)*OS,YF=-PS(kh/10)*OS,K0={draw(e,t){let n=Ge(t*XF),i=qF*n,r=YF*n;e.moveTo(0,-n),e.lineTo(i,r);for(let s=1;s<5;++s){let o=kh*s/5,a=PS(o),c=Dh(o);e.lineTo(c*n,-a*n),e.lineTo(a*i-c*r,c*i+a*r)}e.closePath()}},z0=Ge(3),j0={draw(e,t){let n=-Ge(t/(z0*3));e.moveTo(0,n*2),e.lineTo(-z0*n,-n),e.lineTo(z0*n,-n),e.closePath()}},ZF=Ge(3),Q0={draw(e,t){let n=Ge(t)*.6824,i=n/2,r=n*ZF/2;e.moveTo(0,-n),e.lineTo(r,i),e.lineTo(-r,i),e.closePath()}},ui=-.5,fi=Ge(3)/2,V0=1/Ge(12),JF=(V0/2+1)*3,t_={draw(e,t){let n=Ge(t/JF),i=n/2,r=n*V0,s=i,o=n*V0+n,a=-s,c=o;e.moveTo(i,r),e.lineTo(s,o),e.lineTo(a,c),e.lineTo(ui*i-fi*r,fi*i+ui*r),e.lineTo(ui*s-fi*o,fi*s+ui*o),e.lineTo(ui*a-fi*c,fi*a+ui*c),e.lineTo(ui*i+fi*r,ui*r-fi*i),e.lineTo(ui*s+fi*o,ui*o-fi*s),e.lineTo(ui*a+fi*c,ui*c-fi*a),e.closePath()}},e_={draw(e,t){let n=Ge(t-H0(t/6,1.7))*.6189;e.moveTo(-n,-n),e.lineTo(n,n),e.moveTo(-n,n),e.lineTo(n,-n)}},BS=[to,$0,X0,Z0,K0,j0,t_],kS=[to,Y0,e_,Q0,W0,J0,q0];function ls(){}function Fh(e,t,n){e._context.bezierCurveTo((2*e._x0+e._x1)/3,(2*e._y0+e._y1)/3,(e._x0+2*e._x1)/3,(e._y0+2*e._y1)/3,(e._x0+4*e._x1+t)/6,(e._y0+4*e._y1+n)/6)}function zh(e){this._context=e}zh.prototype={areaStart:function(){this._line=0},areaEnd:function(){this._line=NaN},lineStart:function(){this._x0=this._x1=this._y0=this._y1=NaN,this._point=0},lineEnd:function(){switch(this._point){case 3:Fh(this,this._x1,this._y1);case 2:this._context.lineTo(this._x1,this._y1);break}(this._line||this._line!==0&&this._point===1)&&this._context.closePath(),this._line=1-this._line},point:function(e,t){switch(e=+e,t=+t,this._point){case 0:this._point=1,this._line?this._context.lineTo(e,t):this._context.moveTo(e,t);break;case 1:this._point=2;break;case 2:this._point=3,this._context.lineTo((5*this._x0+this._x1)/6,(5*this._y0+this._y1)/6);default:Fh(this,e,t);break}this._x0=this._x1,this._x1=e,this._y0=this._y1,this._y1=t}};function zS(e){return new zh(e)}function GS(e){this._context=e}GS.prototype={areaStart:ls,areaEnd:ls,lineStart:function(){this._x0=this._x1=this._x2=this._x3=this._x4=this._y0=this._y1=this._y2=this._y3=this._y4=NaN,this._point=0},lineEnd:function(){switch(this._point){case 1:{this._context.moveTo(this._x2,this._y2),this._context.closePath();break}case 2:{this._context.moveTo((this._x2+2*this._x3)/3,(this._y2+2*this._y3)/3),this._context.lineTo((this._x3+2*this._x2)/3,(this._y3+2*this._y2)/3),this._context.closePath();break}case 3:{this.point(this._x2,this._y2),this.point(this._x3,this._y3),this.point(this._x4,this._y4);break}}},point:function(e,t){switch(e=+e,t=+t,this._point){case 0:this._point=1,this._x2=e,this._y2=t;break;case 1:this._point=2,this._x3=e,this._y3=t;break;case 2:this._point=3,this._x4=e,this._y4=t,this._context.moveTo((this._x0+4*this._x1+e)/6,(this._y0+4*this._y1+t)/6);break;default:Fh(this,e,t);break}this._x0=this._x1,this._x1=e,this._y0=this._y1,this._y1=t}};function VS(e){return new GS(e)}function HS(e){this._context=e}HS.prototype={areaStart:function(){this._line=0},areaEnd:function(){this._line=NaN},lineStart:function(){this._x0=this._x1=this._y0=this._y1=NaN,this._point=0},lineEnd:function(){(this._line||this._line!==0&&this._point===3)&&this._context.closePath(),this._line=1-this._line},point:function(e,t){switch(e=+e,t=+t,this._point){case 0:this._point=1;break;case 1:this._point=2;break;case 2:this._point=3;var n=(this._x0+4*this._x1+e)/6,i=(this._y0+4*this._y1+t)/6;this._line?this._context.lineTo(n,i):this._context.moveTo(n,i);break;case 3:this._point=4;default:Fh(this,e,t);break}this._x0=this._x1,this._x1=e,this._y0=this._y1,this._y1=t}};function WS(e){return new HS(e)}function $S(e,t){this._basis=new zh(e),this._beta=t}$S.prototype={lineStart:function(){this._x=[],this._y=[],this._basis.lineStart()},lineEnd:function(){var e=this._x,t=this._y,n=e.length-1;if(n>0)for(var i=e[0],r=t[0],s=e[n]-i,o=t[n]-r,a=-1,c;++a<=n;)c=a/n,this._basis.point(this._beta*e[a]+(1-this._beta)*(i+c*s),this._beta*t[a]+(1-this._beta)*(r+c*o));this._x=this._y=null,this._basis.lineEnd()},point:function(e,t){this._x.push(+e),this._y.push(+t)}};var XS=(function e(t){function n(i){return t===1?new zh(i):new $S(i,t)}return n.beta=function(i){return e(+i)},n})(.85);function Oh(e,t,n){e._context.bezierCurveTo(e._x1+e._k*(e._x2-e._x0),e._y1+e._k*(e._y2-e._y0),e._x2+e._k*(e._x1-t),e._y2+e._k*(e._y1-n),e._x2,e._y2)}function n_(e,t){this._context=e,this._k=(1-t)/6}n_.prototype={areaStart:function(){this._line=0},areaEnd:function(){this._line=NaN},lineStart:function(){this._x0=this._x1=this._x2=this._y0=this._y1=this._y2=NaN,this._point=0},lineEnd:function(){switch(this._point){case 2:this._context.lineTo(this._x2,this._y2);break;case 3:Oh(this,this._x1,this._y1);break}(this._line||this._line!==0&&this._point===1)&&this._context.closePath(),this._line=1-this._line},point:function(e,t){switch(e=+e,t=+t,this._point){case 0:this._point=1,this._line?this._context.lineTo(e,t):this._context.moveTo(e,t);break;case 1:this._point=2,this._x1=e,this._y1=t;break;case 2:this._point=3;default:Oh(this,e,t);break}this._x0=this._x1,this._x1=this._x2,this._x2=e,this._y0=this._y1,this._y1=this._y2,this._y2=t}};var qS=(function e(t){function n(i){return new n_(i,t)}return n.tension=function(i){return e(+i)},n})(0);function i_(e,t){this._context=e,this._k=(1-t)/6}i_.prototype={areaStart:ls,areaEnd:ls,lineStart:function(){this._x0=this._x1=this._x2=this._x3=this._x4=this._x5=this._y0=this._y1=this._y2=this._y3=this._y4=this._y5=NaN,this._point=0},lineEnd:function(){switch(this._point){case 1:{this._context.moveTo(this._x3,this._y3),this._context.closePath();break}case 2:{this._context.lineTo(this._x3,this._y3),this._context.closePath();break}case 3:{this.point(this._x3,this._y3),this.point(this._x4,this._y4),this.point(this._x5,this._y5);break}}},point:function(e,t){switch(e=+e,t=+t,this._point){case 0:this._point=1,this._x3=e,this._y3=t;break;case 1:this._point=2,this._context.moveTo(this._x4=e,this._y4=t);break;case 2:this._point=3,this._x5=e,this._y5=t;break;default:Oh(this,e,t);break}this._x0=this._x1,this._x1=this._x2,this._x2=e,this._y0=this._y1,this._y1=this._y2,this._y2=t}};var YS=(function e(t){function n(i){return new i_(i,t)}return n.tension=function(i){return e(+i)},n})(0);function r_(e,t){this._context=e,this._k=(1-t)/6}r_.prototype={areaStart:function(){this._line=0},areaEnd:function(){this._line=NaN},lineStart:function(){this._x0=this._x1=this._x2=this._y0=this._y1=this._y2=NaN,this._point=0},lineEnd:function(){(this._line||this._line!==0&&this._point===3)&&this._context.closePath(),this._line=1-this._line},point:function(e,t){switch(e=+e,t=+t,this._point){case 0:this._point=1;break;case 1:this._point=2;break;case 2:this._point=3,this._line?this._context.lineTo(this._x2,this._y2):this._context.moveTo(this._x2,this._y2);break;case 3:this._point=4;default:Oh(this,e,t);break}this._x0=this._x1,this._x1=this._x2,this._x2=e,this._y0=this._y1,this._y1=this._y2,this._y2=t}};var ZS=(function e(t){function n(i){return new r_(i,t)}return n.tension=function(i){return e(+i)},n})(0);function s_(e,t,n){var i=e._x1,r=e._y1,s=e._x2,o=e._y2;if(e._l01_a>TS){var a=2*e._l01_2a+3*e._l01_a*e._l12_a+e._l12_2a,c=3*e._l01_a*(e._l01_a+e._l12_a);i=(i*a-e._x0*e._l12_2a+e._x2*e._l01_2a)/c,r=(r*a-e._y0*e._l12_2a+e._y2*e._l01_2a)/c}if(e._l23_a>TS){var l=2*e._l23_2a+3*e._l23_a*e._l12_a+e._l12_2a,u=3*e._l23_a*(e._l23_a+e._l12_a);s=(s*l+e._x1*e._l23_2a-t*e._l12_2a)/u,o=(o*l+e._y1*e._l23_2a-n*e._l12_2a)/u}e._context.bezierCurveTo(i,r,s,o,e._x2,e._y2)}function JS(e,t){this._context=e,this._alpha=t}JS.prototype={areaStart:function(){this._line=0},areaEnd:function(){this._line=NaN},lineStart:function(){this._x0=this._x1=this._x2=this._y0=this._y1=this._y2=NaN,this._l01_a=this._l12_a=this._l23_a=this._l01_2a=this._l12_2a=this._l23_2a=this._point=0},lineEnd:function(){switch(this._point){case 2:this._context.lineTo(this._x2,this._y2);break;case 3:this.point(this._x2,this._y2);break}(this._line||this._line!==0&&this._point===1)&&this._context.closePath(),this._line=1-this._line},point:function(e,t){if(e=+e,t=+t,this._point){var n=this._x2-e,i=this._y2-t;this._l23_a=Math.sqrt(this._l23_2a=Math.pow(n*n+i*i,this._alpha))}switch(this._point){case 0:this._point=1,this._line?this._context.lineTo(e,t):this._context.moveTo(e,t);break;case 1:this._point=2;break;case 2:this._point=3;default:s_(this,e,t);break}this._l01_a=this._l12_a,this._l12_a=this._l23_a,this._l01_2a=this._l12_2a,this._l12_2a=this._l23_2a,this._x0=this._x1,this._x1=this._x2,this._x2=e,this._y0=this._y1,this._y1=this._y2,this._y2=t}};var KS=(function e(t){function n(i){return t?new JS(i,t):new n_(i,0)}return n.alpha=function(i){return e(+i)},n})(.5);function jS(e,t){this._context=e,this._alpha=t}jS.prototype={areaStart:ls,areaEnd:ls,lineStart:function(){this._x0=this._x1=this._x2=this._x3=this._x4=this._x5=this._y0=this._y1=this._y2=this._y3=this._y4=this._y5=NaN,this._l01_a=this._l12_a=this._l23_a=this._l01_2a=this._l12_2a=this._l23_2a=this._point=0},lineEnd:function(){switch(this._point){case 1:{this._context.moveTo(this._x3,this._y3),this._context.closePath();break}case 2:{this._context.lineTo(this._x3,this._y3),this._context.closePath();break}case 3:{this.point(this._x3,this._y3),this.point(this._x4,this._y4),this.point(this._x5,this._y5);break}}},point:function(e,t){if(e=+e,t=+t,this._point){var n=this._x2-e,i=this._y2-t;this._l23_a=Math.sqrt(this._l23_2a=Math.pow(n*n+i*i,this._alpha))}switch(this._point){case 0:this._point=1,this._x3=e,this._y3=t;break;case 1:this._point=2,this._context.moveTo(this._x4=e,this._y4=t);break;case 2:this._point=3,this._x5=e,this._y5=t;break;default:s_(this,e,t);break}this._l01_a=this._l12_a,this._l12_a=this._l23_a,this._l01_2a=this._l12_2a,this._l12_2a=this._l23_2a,this._x0=this._x1,this._x1=this._x2,this._x2=e,this._y0=this._y1,this._y1=this._y2,this._y2=t}};var QS=(function e(t){function n(i){return t?new jS(i,t):new i_(i,0)}return n.alpha=function(i){return e(+i)},n})(.5);function tw(e,t){this._context=e,this._alpha=t}tw.prototype={areaStart:function(){this._line=0},areaEnd:function(){this._line=NaN},lineStart:function(){this._x0=this._x1=this._x2=this._y0=this._y1=this._y2=NaN,this._l01_a=this._l12_a=this._l23_a=this._l01_2a=this._l12_2a=this._l23_2a=this._point=0},lineEnd:function(){(this._line||this._line!==0&&this._point===3)&&this._context.closePath(),this._line=1-this._line},point:function(e,t){if(e=+e,t=+t,this._point){var n=this._x2-e,i=this._y2-t;this._l23_a=Math.sqrt(this._l23_2a=Math.pow(n*n+i*i,this._alpha))}switch(this._point){case 0:this._point=1;break;case 1:this._point=2;break;case 2:this._point=3,this._line?this._context.lineTo(this._x2,this._y2):this._context.moveTo(this._x2,this._y2);break;case 3:this._point=4;default:s_(this,e,t);break}this._l01_a=this._l12_a,this._l12_a=this._l23_a,this._l01_2a=this._l12_2a,this._l12_2a=this._l23_2a,this._x0=this._x1,this._x1=this._x2,this._x2=e,this._y0=this._y1,this._y1=this._y2,this._y2=t}};var ew=(function e(t){function n(i){return t?new tw(i,t):new r_(i,0)}return n.alpha=function(i){return e(+i)},n})(.5);function nw(e){this._context=e}nw.prototype={areaStart:ls,areaEnd:ls,lineStart:function(){this._point=0},lineEnd:function(){this._point&&this._context.closePath()},point:function(e,t){e=+e,t=+t,this._point?this._context.lineTo(e,t):(this._point=1,this._context.moveTo(e,t))}};function iw(e){return new nw(e)}function AS(e){return e<0?-1:1}function ES(e,t,n){var i=e._x1-e._x0,r=t-e._x1,s=(e._y1-e._y0)/(i||r<0&&-0),o=(n-e._y1)/(r||i<0&&-0),a=(s*r+o*i)/(i+r);return(AS(s)+AS(o))*Math.min(Math.abs(s),Math.abs(o),.5*Math.abs(a))||0}function CS(e,t){var n=e._x1-e._x0;return n?(3*(e._y1-e._y0)/n-t)/2:t}function G0(e,t,n){var i=e._x0,r=e._y0,s=e._x1,o=e._y1,a=(s-i)/3;e._context.bezierCurveTo(i+a,r+a*t,s-a,o-a*n,s,o)}function Bh(e){this._context=e}Bh.prototype={areaStart:function(){this._line=0},areaEnd:function(){this._line=NaN},lineStart:function(){this._x0=this._x1=this._y0=this._y1=this._t0=NaN,this._point=0},lineEnd:function(){switch(this._point){case 2:this._context.lineTo(this._x1,this._y1);break;case 3:G0(this,this._t0,CS(this,this._t0));break}(this._line||this._line!==0&&this._point===1)&&this._context.closePath(),this._line=1-this._line},point:function(e,t){var n=NaN;if(e=+e,t=+t,!(e===this._x1&&t===this._y1)){switch(this._point){case 0:this._point=1,this._line?this._context.lineTo(e,t):this._context.moveTo(e,t);break;case 1:this._point=2;break;case 2:this._point=3,G0(this,CS(this,n=ES(this,e,t)),n);break;default:G0(this,this._t0,n=ES(this,e,t));break}this._x0=this._x1,this._x1=e,this._y0=this._y1,this._y1=t,this._t0=n}}};function rw(e){this._context=new sw(e)}(rw.prototype=Object.create(Bh.prototype)).point=function(e,t){Bh.prototype.point.call(this,t,e)};function sw(e){this._context=e}sw.prototype={moveTo:function(e,t){this._context.moveTo(t,e)},closePath:function(){this._context.closePath()},lineTo:function(e,t){this._context.lineTo(t,e)},bezierCurveTo:function(e,t,n,i,r,s){this._context.bezierCurveTo(t,e,i,n,s,r)}};function ow(e){return new Bh(e)}function aw(e){return new rw(e)}function cw(e){this._context=e}cw.prototype={areaStart:function(){this._line=0},areaEnd:function(){this._line=NaN},lineStart:function(){this._x=[],this._y=[]},lineEnd:function(){var e=this._x,t=this._y,n=e.length;if(n)if(this._line?this._context.lineTo(e[0],t[0]):this._context.moveTo(e[0],t[0]),n===2)this._context.lineTo(e[1],t[1]);else for(var i=RS(e),r=RS(t),s=0,o=1;o<n;++s,++o)this._context.bezierCurveTo(i[0][s],r[0][s],i[1][s],r[1][s],e[o],t[o]);(this._line||this._line!==0&&n===1)&&this._context.closePath(),this._line=1-this._line,this._x=this._y=null},point:function(e,t){this._x.push(+e),this._y.push(+t)}};function RS(e){var t,n=e.length-1,i,r=new Array(n),s=new Array(n),o=new Array(n);for(r[0]=0,s[0]=2,o[0]=e[0]+2*e[1],t=1;t<n-1;++t)r[t]=1,s[t]=4,o[t]=4*e[t]+2*e[t+1];for(r[n-1]=2,s[n-1]=7,o[n-1]=8*e[n-1]+e[n],t=1;t<n;++t)i=r[t]/s[t-1],s[t]-=i,o[t]-=i*o[t-1];for(r[n-1]=o[n-1]/s[n-1],t=n-2;t>=0;--t)r[t]=(o[t]-r[t+1])/s[t];for(s[n-1]=(e[n]+r[n-1])/2,t=0;t<n-1;++t)s[t]=2*e[t+1]-r[t+1];return[r,s]}function lw(e){return new cw(e)}function Gh(e,t){this._context=e,this._t=t}Gh.prototype={areaStart:function(){this._line=0},areaEnd:function(){this._line=NaN},lineStart:function(){this._x=this._y=NaN,this._point=0},lineEnd:function(){0<this._t&&this._t<1&&this._point===2&&this._context.lineTo(this._x,this._y),(this._line||this._line!==0&&this._point===1)&&this._context.closePath(),this._line>=0&&(this._t=1-this._t,this._line=1-this._line)},point:function(e,t){switch(e=+e,t=+t,this._point){case 0:this._point=1,this._line?this._context.lineTo(e,t):this._context.moveTo(e,t);break;case 1:this._point=2;default:{if(this._t<=0)this._context.lineTo(this._x,t),this._context.lineTo(e,t);else{var n=this._x*(1-this._t)+e*this._t;this._context.lineTo(n,this._y),this._context.lineTo(n,t)}break}}this._x=e,this._y=t}};function uw(e){return new Gh(e,.5)}function fw(e){return new Gh(e,0)}function hw(e){return new Gh(e,1)}function hi(e){return e!=null&&!Number.isNaN(e)}function Ln(e,t){return+hi(t)-+hi(e)||gn(e,t)}function eo(e,t){return+hi(t)-+hi(e)||br(e,t)}function dl(e){return e!=null&&`${e}`!=""}function o_(e){return isFinite(e)?e:NaN}function no(e){return e>0&&isFinite(e)?e:NaN}function _a(e){return e<0&&isFinite(e)?e:NaN}function Vh(e,t){if(e instanceof Date||(e=new Date(+e)),isNaN(e))return typeof t=="function"?t(e):t;let n=e.getUTCHours(),i=e.getUTCMinutes(),r=e.getUTCSeconds(),s=e.getUTCMilliseconds();return`${KF(e.getUTCFullYear(),4)}-${Pr(e.getUTCMonth()+1,2)}-${Pr(e.getUTCDate(),2)}${n||i||r||s?`T${Pr(n,2)}:${Pr(i,2)}${r||s?`:${Pr(r,2)}${s?`.${Pr(s,3)}`:""}`:""}Z`:""}`}function KF(e){return e<0?`-${Pr(-e,6)}`:e>9999?`+${Pr(e,6)}`:Pr(e,4)}function Pr(e,t){return`${e}`.padStart(t,"0")}var jF=/^(?:[-+]\d{2})?\d{4}(?:-\d{2}(?:-\d{2})?)?(?:T\d{2}:\d{2}(?::\d{2}(?:\.\d{3})?)?(?:Z|[-+]\d{2}:?\d{2})?)?$/;function pl(e,t){return jF.test(e+="")?new Date(e):typeof t=="function"?t(e):t}function Ir(e){if(e==null)return;let t=e[0],n=e[e.length-1];return br(t,n)}var xa=1e3,fs=xa*60,hs=fs*60,Qi=hs*24,ji=Qi*7,io=Qi*30,us=Qi*365,a_=[["millisecond",1],["2 milliseconds",2],["5 milliseconds",5],["10 milliseconds",10],["20 milliseconds",20],["50 milliseconds",50],["100 milliseconds",100],["200 milliseconds",200],["500 milliseconds",500],["second",xa],["5 seconds",5*xa],["15 seconds",15*xa],["30 seconds",30*xa],["minute",fs],["5 minutes",5*fs],["15 minutes",15*fs],["30 minutes",30*fs],["hour",hs],["3 hours",3*hs],["6 hours",6*hs],["12 hours",12*hs],["day",Qi],["2 days",2*Qi],["week",ji],["2 weeks",2*ji],["month",io],["3 months",3*io],["6 months",6*io],["year",us],["2 years",2*us],["5 years",5*us],["10 years",10*us],["20 years",20*us],["50 years",50*us],["100 years",100*us]],c_=new Map([["second",xa],["minute",fs],["hour",hs],["day",Qi],["monday",ji],["tuesday",ji],["wednesday",ji],["thursday",ji],["friday",ji],["saturday",ji],["sunday",ji],["week",ji],["month",io],["year",us]]),pw=new Map([["second",wn],["minute",Ws],["hour",Xs],["day",qi],["monday",Zs],["tuesday",ug],["wednesday",fg],["thursday",Cr],["friday",hg],["saturday",dg],["sunday",Yi],["week",Yi],["month",js],["year",Pn]]),l_=new Map([["second",wn],["minute",$s],["hour",qs],["day",nl],["monday",Ks],["tuesday",pg],["wednesday",mg],["thursday",Rr],["friday",gg],["saturday",_g],["sunday",Zi],["week",Zi],["month",Qs],["year",In]]),va=Symbol("intervalDuration"),Wh=Symbol("intervalType");for(let[e,t]of pw)t[va]=c_.get(e),t[Wh]="time";for(let[e,t]of l_)t[va]=c_.get(e),t[Wh]="utc";var ml=[["year",In,"utc"],["month",Qs,"utc"],["day",nl,"utc",6*io],["hour",qs,"utc",3*Qi],["minute",$s,"utc",6*hs],["second",wn,"utc",30*fs]],Hh=[["year",Pn,"time"],["month",js,"time"],["day",qi,"time",6*io],["hour",Xs,"time",3*Qi],["minute",Ws,"time",6*hs],["second",wn,"time",30*fs]],QF=[ml[0],Hh[0],ml[1],Hh[1],ml[2],Hh[2],...ml.slice(3)];function mw(e){let t=`${e}`.toLowerCase();t.endsWith("s")&&(t=t.slice(0,-1));let n=1,i=/^(?:(\d+)\s+)/.exec(t);switch(i&&(t=t.slice(i[0].length),n=+i[1]),t){case"quarter":t="month",n*=3;break;case"half":t="month",n*=6;break}let r=l_.get(t);if(!r)throw new Error(`unknown interval: ${e}`);if(n>1&&!r.every)throw new Error(`non-periodic interval: ${t}`);return[t,n]}function u_(e){return gw(mw(e),"time")}function f_(e){return gw(mw(e),"utc")}function gw([e,t],n){let i=(n==="time"?pw:l_).get(e);return t>1&&(i=i.every(t),i[va]=c_.get(e)*t,i[Wh]=n),i}function h_(e,t){if(!(t>1))return;let n=e[va];if(!a_.some(([,r])=>r===n)||n%Qi===0&&Qi<n&&n<io)return;let[i]=a_[Yo(([,r])=>Math.log(r)).center(a_,Math.log(n*t))];return(e[Wh]==="time"?u_:f_)(i)}function dw(e,t,n){let i=t==="time"?ol:Ji;if(n==null)return i(e==="year"?"%Y":e==="month"?"%Y-%m":e==="day"?"%Y-%m-%d":e==="hour"||e==="minute"?"%Y-%m-%dT%H:%M":e==="second"?"%Y-%m-%dT%H:%M:%S":"%Y-%m-%dT%H:%M:%S.%L");let r=tO(n);switch(e){case"millisecond":return ya(i(".%L"),i(":%M:%S"),r);case"second":return ya(i(":%S"),i("%-I:%M"),r);case"minute":return ya(i("%-I:%M"),i("%p"),r);case"hour":return ya(i("%-I %p"),i("%b %-d"),r);case"day":return ya(i("%-d"),i("%b"),r);case"month":return ya(i("%b"),i("%Y"),r);case"year":return i("%Y")}throw new Error("unable to format time ticks")}function tO(e){return e==="left"||e==="right"?(t,n)=>`
${t}
${n}`:e==="top"?(t,n)=>`${n}
${t}`:(t,n)=>`${t}
${n}`}function eO(e){return e==="time"?Hh:e==="utc"?ml:QF}function _w(e,t,n){let i=bn(gb(t,(r,s)=>Math.abs(s-r)));if(i<1e3)return dw("millisecond","utc",n);for(let[r,s,o,a]of eO(e)){if(i>a||r==="hour"&&!i)break;if(t.every(c=>s.floor(c)>=c))return dw(r,o,n)}}function ya(e,t,n){return(i,r,s)=>{let o=e(i,r),a=t(i,r),c=r-Ir(s);return r!==c&&s[c]!==void 0&&a===t(s[c],c)?o:n(o,a)}}var p_=Object.getPrototypeOf(Uint8Array),nO=Object.prototype.toString;function Ci(e){return e instanceof Array||e instanceof p_}function vw(e){return e instanceof p_&&!iO(e)}function bw(e){return e?.prototype instanceof p_&&!rO(e)}function iO(e){return e instanceof BigInt64Array||e instanceof BigUint64Array}function rO(e){return e===BigInt64Array||e===BigUint64Array}var m_=Symbol("reindex");function Qe(e,t,n){let i=typeof t;return i==="string"?kw(e)?g_(e.getChild(t),n):yw(e,__(t),n):i==="function"?yw(e,t,n):i==="number"||t instanceof Date||i==="boolean"?ye(e,Vn(t),n):typeof t?.transform=="function"?d_(t.transform(e),n):sO(d_(t,n),e?.[m_])}function sO(e,t){return e!=null&&t?qh(e,t):e}function yw(e,t,n){return ye(e,bw(n)?(i,r)=>x_(t(i,r)):t,n)}function d_(e,t){return t===void 0?er(e):zw(e)?g_(e,t):e instanceof t?e:t.from(e,bw(t)&&!vw(e)?x_:void 0)}function g_(e,t){return e==null?e:(t===void 0||t===Array)&&uO(e.type)?v_(xw(e)):d_(xw(e),t)}function xw(e){return e.nullCount?e.toJSON():e.toArray()}var ba=[null],__=e=>t=>{let n=t[e];return n===void 0&&t.type==="Feature"?t.properties?.[e]:n},ro={transform:Nn},be={transform:e=>e};var Mw=()=>1,Sw=()=>!0,Pe=e=>e==null?e:`${e}`,Ie=e=>e==null?e:+e;var y_=e=>e?e[0]:void 0,ww=e=>e?e[1]:void 0;var Vn=e=>()=>e;function Tw(e){let t=+`${e}`.slice(1)/100;return(n,i)=>Us(n,t,i)}function so(e){return vw(e)?e:ye(e,x_,Float64Array)}function x_(e){return e==null?NaN:Number(e)}function v_(e){return ye(e,oO)}function oO(e){return e instanceof Date&&!isNaN(e)?e:typeof e=="string"?pl(e):e==null||isNaN(e=Number(e))?void 0:new Date(e)}function tr(e,t){return e===void 0&&(e=t),e===null?[void 0,"none"]:wa(e)?[void 0,e]:[e,void 0]}function Ce(e,t){return e===void 0&&(e=t),e===null||typeof e=="number"?[void 0,e]:[e,void 0]}function b_(e,t,n){if(e!=null)return Tn(e,t,n)}function Tn(e,t,n){let i=`${e}`.toLowerCase();if(!n.includes(i))throw new Error(`invalid ${t}: ${e}`);return i}function Lr(e){return kw(e)?e:er(e)}function er(e){if(e==null||Ci(e))return e;if(zw(e))return g_(e);if(Aw(e))switch(e.type){case"FeatureCollection":return e.features;case"GeometryCollection":return e.geometries;default:return[e]}return Array.from(e)}function Aw(e){switch(e?.type){case"FeatureCollection":case"GeometryCollection":case"Feature":case"LineString":case"MultiLineString":case"MultiPoint":case"MultiPolygon":case"Point":case"Polygon":case"Sphere":return!0;default:return!1}}function ye(e,t,n=Array){return e==null?e:e instanceof n?e.map(t):n.from(e,t)}function ds(e,t=Array){return e instanceof t?e.slice():t.from(e)}function M_({x:e,x1:t,x2:n}){return e!==void 0||t!==void 0||n!==void 0}function S_({y:e,y1:t,y2:n}){return e!==void 0||t!==void 0||n!==void 0}function $h(e){return M_(e)||S_(e)||e.interval!==void 0}function nr(e){return e?.toString===nO}function Ma(e){return nr(e)&&(e.type!==void 0||e.domain!==void 0)}function Sa(e){return nr(e)&&typeof e.transform!="function"}function ps(e){return Sa(e)&&e.value===void 0&&e.channel===void 0}function w_(e,t,n,i=be){return t===void 0&&n===void 0?(t=0,n=e===void 0?i:e):t===void 0?t=e===void 0?0:e:n===void 0&&(n=e===void 0?0:e),[t,n]}function Nr(e,t){return e===void 0&&t===void 0?[y_,ww]:[e,t]}function Xh({z:e,fill:t,stroke:n}={}){return e===void 0&&([e]=tr(t)),e===void 0&&([e]=tr(n)),e}function ms(e){return Ci(e)?e.length:e?.numRows}function Nn(e){let t=ms(e),n=new Uint32Array(t);for(let i=0;i<t;++i)n[i]=i;return n}function qh(e,t){return Ci(e)?ye(t,n=>e[n],e.constructor):ye(t,n=>e.at(n))}function Ew(e,t,n){return e.subarray?e.subarray(t,n):e.slice(t,n)}function di(e){return e!==null&&typeof e=="object"?e.valueOf():e}function gl(e){let t;return[{transform:()=>t,label:gs(e)},n=>t=n]}function Cw(e){return e==null?[e]:gl(e)}function gs(e,t){return typeof e=="string"?e:e&&e.label!==void 0?e.label:t}function T_(e,t){return{transform(n){let i=e.transform(n),r=t.transform(n);return je(i)||je(r)?ye(i,(s,o)=>new Date((+i[o]+ +r[o])/2)):ye(i,(s,o)=>(+i[o]+ +r[o])/2,Float64Array)},label:e.label}}function Rw(e,t){let n=A_(t?.interval,t?.type);return n?ye(e,n):e}function A_(e,t){let n=Yh(e,t);return n&&(i=>hi(i)?n.floor(i):i)}function Yh(e,t){if(e!=null){if(typeof e=="number")return aO(e);if(typeof e=="string")return(t==="time"?u_:f_)(e);if(typeof e.floor!="function")throw new Error("invalid interval; missing floor method");if(typeof e.offset!="function")throw new Error("invalid interval; missing offset method");return e}}function aO(e){e=+e,0<e&&e<1&&Number.isInteger(1/e)&&(e=-1/e);let t=Math.abs(e);return e<0?{floor:n=>Math.floor(n*t)/t,offset:(n,i=1)=>(n*t+Math.floor(i))/t,range:(n,i)=>Ko(Math.ceil(n*t),i*t).map(r=>r/t)}:{floor:n=>Math.floor(n/t)*t,offset:(n,i=1)=>n+t*Math.floor(i),range:(n,i)=>Ko(Math.ceil(n/t),i/t).map(r=>r*t)}}function _s(e,t){if(e=Yh(e,t),e&&typeof e.range!="function")throw new Error("invalid interval: missing range method");return e}function Pw(e,t){if(e=_s(e,t),e&&typeof e.ceil!="function")throw new Error("invalid interval: missing ceil method");return e}function Iw(e){return typeof e?.range=="function"}function ys(e){return e===void 0||Sa(e)?e:{value:e}}function Lw(e){return e==null?null:{transform:t=>Qe(t,e,Float64Array),label:gs(e)}}function pi(e){return e&&typeof e[Symbol.iterator]=="function"}function Zh(e){for(let t of e)if(t!=null)return typeof t!="object"||t instanceof Date}function E_(e){for(let t of e){if(t==null)continue;let n=typeof t;return n==="string"||n==="boolean"}}function je(e){for(let t of e)if(t!=null)return t instanceof Date}function Nw(e){for(let t of e)if(t!=null)return typeof t=="string"&&isNaN(t)&&pl(t)}function Dw(e){for(let t of e)if(t!=null){if(typeof t!="string")return!1;if(t.trim())return!isNaN(t)}}function Uw(e){for(let t of e)if(t!=null)return typeof t=="number"}function Jh(e,t){let n;for(let i of e)if(i!=null){if(!t(i))return!1;n=!0}return n}var cO=new Set("none,currentcolor,transparent,aliceblue,antiquewhite,aqua,aquamarine,azure,beige,bisque,black,blanchedalmond,blue,blueviolet,brown,burlywood,cadetblue,chartreuse,chocolate,coral,cornflowerblue,cornsilk,crimson,cyan,darkblue,darkcyan,darkgoldenrod,darkgray,darkgreen,darkgrey,darkkhaki,darkmagenta,darkolivegreen,darkorange,darkorchid,darkred,darksalmon,darkseagreen,darkslateblue,darkslategray,darkslategrey,darkturquoise,darkviolet,deeppink,deepskyblue,dimgray,dimgrey,dodgerblue,firebrick,floralwhite,forestgreen,fuchsia,gainsboro,ghostwhite,gold,goldenrod,gray,green,greenyellow,grey,honeydew,hotpink,indianred,indigo,ivory,khaki,lavender,lavenderblush,lawngreen,lemonchiffon,lightblue,lightcoral,lightcyan,lightgoldenrodyellow,lightgray,lightgreen,lightgrey,lightpink,lightsalmon,lightseagreen,lightskyblue,lightslategray,lightslategrey,lightsteelblue,lightyellow,lime,limegreen,linen,magenta,maroon,mediumaquamarine,mediumblue,mediumorchid,mediumpurple,mediumseagreen,mediumslateblue,mediumspringgreen,mediumturquoise,mediumvioletred,midnightblue,mintcream,mistyrose,moccasin,navajowhite,navy,oldlace,olive,olivedrab,orange,orangered,orchid,palegoldenrod,palegreen,paleturquoise,palevioletred,papayawhip,peachpuff,peru,pink,plum,powderblue,purple,rebeccapurple,red,rosybrown,royalblue,saddlebrown,salmon,sandybrown,seagreen,seashell,sienna,silver,skyblue,slateblue,slategray,slategrey,snow,springgreen,steelblue,tan,teal,thistle,tomato,turquoise,violet,wheat,white,whitesmoke,yellow".split(","));function wa(e){return typeof e!="string"?!1:(e=e.toLowerCase().trim(),/^#[0-9a-f]{3,8}$/.test(e)||/^(?:url|var|rgb|rgba|hsl|hsla|hwb|lab|lch|oklab|oklch|color|color-mix)\(.*\)$/.test(e)||cO.has(e))}function Fw(e){return typeof e=="number"&&(0<=e&&e<=1||isNaN(e))}function tn(e){return e==null||oo(e)}function oo(e){return/^\s*none\s*$/i.test(e)}function Ow(e){return/^\s*round\s*$/i.test(e)}function Kh(e,t){return b_(e,t,["middle","top-left","top","top-right","right","bottom-right","bottom","bottom-left","left"])}function xs(e="middle"){return Kh(e,"frameAnchor")}function Bw(e={},...t){let n=e;for(let i of t)for(let r in i)if(n[r]===void 0){let s=i[r];n===e?n={...n,[r]:s}:n[r]=s}return n}function lO(e){console.warn("named iterables are deprecated; please use an object instead");let t=new Set;return Object.fromEntries(Array.from(e,n=>{let{name:i}=n;if(i==null)throw new Error("missing name");let r=`${i}`;if(r==="__proto__")throw new Error(`illegal name: ${r}`);if(t.has(r))throw new Error(`duplicate name: ${r}`);return t.add(r),[i,n]}))}function C_(e){return pi(e)?lO(e):e}function jh(e){return e===!0?e="frame":e===!1?e=null:!Aw(e)&&e!=null&&(e=Tn(e,"clip",["frame","sphere"]),e==="sphere"&&(e={type:"Sphere"})),e}function kw(e){return e&&typeof e.getChild=="function"&&typeof e.toArray=="function"&&e.schema&&Array.isArray(e.schema.fields)}function zw(e){return e&&typeof e.toArray=="function"&&e.type}function uO(e){return e&&(e.typeId===8||e.typeId===10)&&e.unit===1}var mi=Symbol("position"),Hn=Symbol("color"),ao=Symbol("radius"),co=Symbol("length"),lo=Symbol("opacity"),Ta=Symbol("symbol"),Gw=Symbol("projection"),pe=new Map([["x",mi],["y",mi],["fx",mi],["fy",mi],["r",ao],["color",Hn],["opacity",lo],["symbol",Ta],["length",co],["projection",Gw]]);function Vw(e){return e===mi||e===Gw}function Hw(e){return e===mi||e===ao||e===co||e===lo}var fO=Math.sqrt(3),hO=2/fO,dO={draw(e,t){let n=Math.sqrt(t/Math.PI),i=n*hO,r=i/2;e.moveTo(0,i),e.lineTo(n,r),e.lineTo(n,-r),e.lineTo(0,-i),e.lineTo(-n,-r),e.lineTo(-n,r),e.closePath()}},R_=new Map([["asterisk",W0],["circle",to],["cross",$0],["diamond",X0],["diamond2",q0],["hexagon",dO],["plus",Y0],["square",Z0],["square2",J0],["star",K0],["times",e_],["triangle",j0],["triangle2",Q0],["wye",t_]]);function P_(e){return e&&typeof e.draw=="function"}function Ww(e){return P_(e)?!0:typeof e!="string"?!1:R_.has(e.toLowerCase())}function Aa(e){if(e==null||P_(e))return e;let t=R_.get(`${e}`.toLowerCase());if(t)return t;throw new Error(`invalid symbol: ${e}`)}function $w(e){if(e==null||P_(e))return[void 0,e];if(typeof e=="string"){let t=R_.get(`${e}`.toLowerCase());if(t)return[void 0,t]}return[e,void 0]}function _l({filter:e,sort:t,reverse:n,transform:i,initializer:r,...s}={},o){if(i===void 0&&(e!=null&&(i=Xw(e)),t!=null&&!ps(t)&&(i=I_(i,N_(t))),n&&(i=I_(i,qw))),o!=null&&r!=null)throw new Error("transforms cannot be applied after initializers");return{...s,...(t===null||ps(t))&&{sort:t},transform:I_(i,o)}}function Dr({filter:e,sort:t,reverse:n,initializer:i,...r}={},s){return i===void 0&&(e!=null&&(i=Xw(e)),t!=null&&!ps(t)&&(i=L_(i,N_(t))),n&&(i=L_(i,qw))),{...r,...(t===null||ps(t))&&{sort:t},initializer:L_(i,s)}}function I_(e,t){return e==null?t===null?void 0:t:t==null?e===null?void 0:e:function(n,i,r){return{data:n,facets:i}=e.call(this,n,i,r),t.call(this,Lr(n),i,r)}}function L_(e,t){return e==null?t===null?void 0:t:t==null?e===null?void 0:e:function(n,i,r,...s){let o,a,c,l,u,h;return{data:a=n,facets:c=i,channels:o}=e.call(this,n,i,r,...s),{data:u=a,facets:h=c,channels:l}=t.call(this,a,c,{...r,...o},...s),{data:u,facets:h,channels:{...o,...l}}}}function pO(e,t){return(e.initializer!=null?Dr:_l)(e,t)}function Xw(e){return(t,n)=>{let i=Qe(t,e);return{data:t,facets:n.map(r=>r.filter(s=>i[s]))}}}function qw(e,t){return{data:e,facets:t.map(n=>n.slice().reverse())}}function Yw(e,{sort:t,...n}={}){return{...(Sa(e)&&e.channel!==void 0?Dr:pO)(n,N_(e)),sort:ps(t)?t:null}}function N_(e){return(typeof e=="function"&&e.length!==1?mO:gO)(e)}function mO(e){return(t,n)=>{let i=Ci(t)?(r,s)=>e(t[r],t[s]):(r,s)=>e(t.get(r),t.get(s));return{data:t,facets:n.map(r=>r.slice().sort(i))}}}function gO(e){let t,n;({channel:t,value:e,order:n}={...ys(e)});let i=t?.startsWith("-");if(i&&(t=t.slice(1)),n===void 0&&(n=i?eo:Ln),typeof n!="function")switch(`${n}`.toLowerCase()){case"ascending":n=Ln;break;case"descending":n=eo;break;default:throw new Error(`invalid order: ${n}`)}return(r,s,o)=>{let a;if(t===void 0)a=Qe(r,e);else{if(o===void 0)throw new Error("channel sort requires an initializer");if(a=o[t],!a)return{};a=a.value}let c=(l,u)=>n(a[l],a[u]);return{data:r,facets:s.map(l=>l.slice().sort(c))}}}function jw(e,t,n=_O){if(e==null)return n(e);if(typeof e.reduceIndex=="function")return e;if(typeof e.reduce=="function"&&nr(e))return yO(e);if(typeof e=="function")return xO(e);if(/^p\d{2}$/i.test(e))return Ur(Tw(e));switch(`${e}`.toLowerCase()){case"first":return bO;case"last":return MO;case"identity":return vO;case"count":return Jw;case"distinct":return SO;case"sum":return t==null?Jw:wO;case"proportion":return Kw(t,"data");case"proportion-facet":return Kw(t,"facet");case"deviation":return Ur(rb);case"min":return Ur(ei);case"min-index":return Ur(fb);case"max":return Ur(bn);case"max-index":return Ur(ub);case"mean":return Zw(pb);case"median":return Zw(Uc);case"variance":return Ur(lm);case"mode":return Ur(mb)}return n(e)}function _O(e){throw new Error(`invalid reduce: ${e}`)}function yO(e){return console.warn("deprecated reduce interface; implement reduceIndex instead."),{...e,reduceIndex:e.reduce.bind(e)}}function xO(e){return{reduceIndex(t,n,i){return e(qh(n,t),i)}}}function Ur(e){return{reduceIndex(t,n){return e(t,i=>n[i])}}}function Zw(e){return{reduceIndex(t,n){let i=e(t,r=>n[r]);return je(n)?new Date(i):i}}}var vO={reduceIndex(e,t){return qh(t,e)}},bO={reduceIndex(e,t){return t[e[0]]}};var MO={reduceIndex(e,t){return t[e[e.length-1]]}},Jw={label:"Frequency",reduceIndex(e){return e.length}},SO={label:"Distinct",reduceIndex(e,t){let n=new ki;for(let i of e)n.add(t[i]);return n.size}},wO=Ur(zi);function Kw(e,t){return e==null?{scope:t,label:"Frequency",reduceIndex:(n,i,r=1)=>n.length/r}:{scope:t,reduceIndex:(n,i,r=1)=>zi(n,s=>i[s])/r}}function Ea(e,{scale:t,type:n,value:i,filter:r,hint:s,label:o=gs(i)},a){return s===void 0&&typeof i?.transform=="function"&&(s=i.hint),U_(a,{scale:t,type:n,value:Qe(e,i),label:o,filter:r,hint:s})}function tT(e,t){return Object.fromEntries(Object.entries(e).map(([n,i])=>[n,Ea(t,i,n)]))}function eT(e,t){let n=Object.fromEntries(Object.entries(e).map(([i,{scale:r,value:s}])=>{let o=r==null?null:t[r];return[i,o==null?s:ye(s,o)]}));return n.channels=e,n}function U_(e,t){let{scale:n,value:i}=t;if(n===!0||n==="auto")switch(e){case"fill":case"stroke":case"color":t.scale=n!==!0&&Jh(i,wa)?null:"color",t.defaultScale="color";break;case"fillOpacity":case"strokeOpacity":case"opacity":t.scale=n!==!0&&Jh(i,Fw)?null:"opacity",t.defaultScale="opacity";break;case"symbol":n!==!0&&Jh(i,Ww)?(t.scale=null,t.value=ye(i,Aa)):t.scale="symbol",t.defaultScale="symbol";break;default:t.scale=pe.has(e)?e:null;break}else if(n===!1)t.scale=null;else if(n!=null&&!pe.has(n))throw new Error(`unknown scale: ${n}`);return t}function nT(e,t,n,i,r){let{order:s,reverse:o,reduce:a=!0,limit:c}=r;for(let l in r){if(!pe.has(l))continue;let{value:u,order:h=s,reverse:f=o,reduce:d=a,limit:p=c}=ys(r[l]),_=u?.startsWith("-");if(_&&(u=u.slice(1)),h=h===void 0?_!==(u==="width"||u==="height")?rT:iT:EO(h),d==null||d===!1)continue;let g=l==="fx"||l==="fy"?AO(t,i[l]):TO(n,l);if(!g)throw new Error(`missing channel for scale: ${l}`);let m=g.value,[x=0,S=1/0]=pi(p)?p:p<0?[p]:[0,p];if(u==null)g.domain=()=>{let v=Array.from(new ki(m));return f&&(v=v.reverse()),(x!==0||S!==1/0)&&(v=v.slice(x,S)),v};else{let v=u==="data"?e:u==="height"?Qw(n,"y1","y2"):u==="width"?Qw(n,"x1","x2"):D_(n,u,u==="y"?"y2":u==="x"?"x2":void 0),w=jw(d===!0?"max":d,v);g.domain=()=>{let b=cb(Nn(m),y=>w.reduceIndex(y,v),y=>m[y]);return h&&b.sort(h),f&&b.reverse(),(x!==0||S!==1/0)&&(b=b.slice(x,S)),b.map(y_)}}}}function TO(e,t){for(let n in e){let i=e[n];if(i.scale===t)return i}}function AO(e,t){let n=e.original;if(n===e)return t;let i=t.value,r=t.value=[];for(let s=0;s<n.length;++s){let o=i[n[s][0]];for(let a of e[s])r[a]=o}return t}function Qw(e,t,n){let i=D_(e,t),r=D_(e,n);return ye(r,(s,o)=>Math.abs(s-i[o]),Float64Array)}function D_(e,t,n){let i=e[t];if(!i&&n!==void 0&&(i=e[n]),i)return i.value;throw new Error(`missing channel: ${t}`)}function EO(e){if(e==null||typeof e=="function")return e;switch(`${e}`.toLowerCase()){case"ascending":return iT;case"descending":return rT}throw new Error(`invalid order: ${e}`)}function iT([e,t],[n,i]){return Ln(t,i)||Ln(e,n)}function rT([e,t],[n,i]){return eo(t,i)||Ln(e,n)}function F_(e,t){let n=e[t];if(n){for(;n.source;)n=n.source;return n.source===null?null:n}}var lT=new Map([["accent",mS],["category10",pS],["dark2",gS],["observable10",_S],["paired",yS],["pastel1",xS],["pastel2",vS],["set1",bS],["set2",MS],["set3",SS],["tableau10",wS]]);function uT(e){return e!=null&&lT.has(`${e}`.toLowerCase())}var sT=new Map([...lT,["brbg",Fr(Ng,Dg)],["prgn",Fr(Ug,Fg)],["piyg",Fr(Og,Bg)],["puor",Fr(kg,zg)],["rdbu",Fr(Ih,ul)],["rdgy",Fr(Gg,Vg)],["rdylbu",Fr(Lh,fl)],["rdylgn",Fr(Hg,Wg)],["spectral",Fr($g,Xg)],["burd",oT(Ih,ul)],["buylrd",oT(Lh,fl)],["blues",en(_0,y0)],["greens",en(x0,v0)],["greys",en(b0,M0)],["oranges",en(E0,C0)],["purples",en(S0,w0)],["reds",en(T0,A0)],["turbo",Or(U0)],["viridis",Or(F0)],["magma",Or(O0)],["inferno",Or(B0)],["plasma",Or(k0)],["cividis",Or(R0)],["cubehelix",Or(P0)],["warm",Or(I0)],["cool",Or(L0)],["bugn",en(qg,Yg)],["bupu",en(Zg,Jg)],["gnbu",en(Kg,jg)],["orrd",en(Qg,t0)],["pubu",en(i0,r0)],["pubugn",en(e0,n0)],["purd",en(s0,o0)],["rdpu",en(a0,c0)],["ylgn",en(f0,h0)],["ylgnbu",en(l0,u0)],["ylorbr",en(d0,p0)],["ylorrd",en(m0,g0)],["rainbow",aT(N0)],["sinebow",aT(D0)]]);function en(e,t){return({length:n})=>n===1?[e[3][1]]:n===2?[e[3][1],e[3][2]]:(n=Math.max(3,Math.floor(n)),n>9?Mn(t,n):e[n])}function Fr(e,t){return({length:n})=>n===2?[e[3][0],e[3][2]]:(n=Math.max(3,Math.floor(n)),n>11?Mn(t,n):e[n])}function oT(e,t){return({length:n})=>n===2?[e[3][2],e[3][0]]:(n=Math.max(3,Math.floor(n)),n>11?Mn(i=>t(1-i),n):e[n].slice().reverse())}function Or(e){return({length:t})=>Mn(e,Math.max(2,Math.floor(t)))}function aT(e){return({length:t})=>Mn(e,Math.floor(t)+1).slice(0,-1)}function O_(e){let t=`${e}`.toLowerCase();if(!sT.has(t))throw new Error(`unknown ordinal scheme: ${t}`);return sT.get(t)}function yl(e,t){let n=O_(e),i=typeof n=="function"?n({length:t}):n;return i.length!==t?i.slice(0,t):i}function fT(e,t="greys"){let n=new Set,[i,r]=yl(t,2);for(let s of e)if(s!=null)if(s===!0)n.add(r);else if(s===!1)n.add(i);else return;return[...n]}var cT=new Map([["brbg",Dg],["prgn",Fg],["piyg",Bg],["puor",zg],["rdbu",ul],["rdgy",Vg],["rdylbu",fl],["rdylgn",Wg],["spectral",Xg],["burd",e=>ul(1-e)],["buylrd",e=>fl(1-e)],["blues",y0],["greens",v0],["greys",M0],["purples",w0],["reds",A0],["oranges",C0],["turbo",U0],["viridis",F0],["magma",O0],["inferno",B0],["plasma",k0],["cividis",R0],["cubehelix",P0],["warm",I0],["cool",L0],["bugn",Yg],["bupu",Jg],["gnbu",jg],["orrd",t0],["pubugn",n0],["pubu",r0],["purd",o0],["rdpu",c0],["ylgnbu",u0],["ylgn",h0],["ylorbr",p0],["ylorrd",g0],["rainbow",N0],["sinebow",D0]]);function Ca(e){let t=`${e}`.toLowerCase();if(!cT.has(t))throw new Error(`unknown quantitative scheme: ${t}`);return cT.get(t)}var CO=new Set(["brbg","prgn","piyg","puor","rdbu","rdgy","rdylbu","rdylgn","spectral","burd","buylrd"]);function hT(e){return e!=null&&CO.has(`${e}`.toLowerCase())}var k_=e=>t=>e(1-t),B_=[0,1],dT=new Map([["number",ke],["rgb",zs],["hsl",c1],["hcl",f1],["lab",l1]]);function z_(e){let t=`${e}`.toLowerCase();if(!dT.has(t))throw new Error(`unknown interpolator: ${t}`);return dT.get(t)}function Pa(e,t,n,{type:i,nice:r,clamp:s,zero:o,domain:a=MT(e,n),unknown:c,round:l,scheme:u,interval:h,range:f=pe.get(e)===ao?LO(n,a):pe.get(e)===co?NO(n,a):pe.get(e)===lo?B_:void 0,interpolate:d=pe.get(e)===Hn?u==null&&f!==void 0?zs:Ca(u!==void 0?u:i==="cyclical"?"rainbow":"turbo"):l?kc:ke,reverse:p}){if(a=pT(a),h=_s(h,i),(i==="cyclical"||i==="sequential")&&(i="linear"),typeof d!="function"&&(d=z_(d)),p=!!p,f!==void 0){let _=a.length,g=(f=pT(f)).length;if(_!==g){if(d.length===1)throw new Error("invalid piecewise interpolator");d=os(d,f),f=void 0}}if(d.length===1?(p&&(d=k_(d),p=!1),f===void 0&&(f=Float64Array.from(a,(_,g)=>g/(a.length-1)),f.length===2&&(f=B_)),t.interpolate((f===B_?Vn:xl)(d))):t.interpolate(d),o){let[_,g]=ni(a);(_>0||g<0)&&(a=ds(a),(Ir(a)||1)===Math.sign(_)?a[0]=0:a[a.length-1]=0)}return p&&(a=jo(a)),t.domain(a).unknown(c),r&&(t.nice(RO(r,i)),a=t.domain()),f!==void 0&&t.range(f),s&&t.clamp(s),{type:i,domain:a,range:f,scale:t,interpolate:d,interval:h}}function pT(e){return e=er(e),e.length>=2?e:[e[0],e[0]]}function RO(e,t){return e===!0?void 0:typeof e=="number"?e:Pw(e,t)}function mT(e,t,n){return Pa(e,ll(),t,n)}function gT(e,t,n){return G_(e,t,{...n,exponent:.5})}function G_(e,t,{exponent:n=1,...i}){return Pa(e,Tg().exponent(n),t,{...i,type:"pow"})}function _T(e,t,{base:n=10,domain:i=DO(t),...r}){return Pa(e,Sg().base(n),t,{...r,domain:i})}function yT(e,t,{constant:n=1,...i}){return Pa(e,wg().constant(n),t,i)}function xT(e,t,{range:n,quantiles:i=n===void 0?5:(n=[...n]).length,n:r=i,scheme:s="rdylbu",domain:o=UO(t),unknown:a,interpolate:c,reverse:l}){return n===void 0&&(n=c!==void 0?Mn(c,r):pe.get(e)===Hn?yl(s,r):void 0),o.length>0&&(o=Ag(o,n===void 0?{length:r}:n).quantiles()),Qh(e,t,{domain:o,range:n,reverse:l,unknown:a})}function vT(e,t,{range:n,n:i=n===void 0?5:(n=[...n]).length,scheme:r="rdylbu",domain:s=MT(e,t),unknown:o,interpolate:a,reverse:c}){let[l,u]=ni(s),h;return n===void 0?(h=Jo(l,u,i),h[0]<=l&&h.splice(0,1),h[h.length-1]>=u&&h.pop(),i=h.length+1,n=a!==void 0?Mn(a,i):pe.get(e)===Hn?yl(r,i):void 0):(h=Mn(ke(l,u),i+1).slice(1,-1),l instanceof Date&&(h=h.map(f=>new Date(f)))),Ir(er(s))<0&&h.reverse(),Qh(e,t,{domain:h,range:n,reverse:c,unknown:o})}function Qh(e,t,{domain:n=[0],unknown:i,scheme:r="rdylbu",interpolate:s,range:o=s!==void 0?Mn(s,n.length+1):pe.get(e)===Hn?yl(r,n.length+1):void 0,reverse:a}){n=er(n);let c=Ir(n);if(!isNaN(c)&&!PO(n,c))throw new Error(`the ${e} scale has a non-monotonic domain`);return a&&(o=jo(o)),{type:"threshold",scale:Eg(c<0?jo(n):n,o===void 0?[]:o).unknown(i),domain:n,range:o}}function PO(e,t){for(let n=1,i=e.length,r=e[0];n<i;++n){let s=br(r,r=e[n]);if(s!==0&&s!==t)return!1}return!0}function bT(e){return{type:"identity",scale:Hw(pe.get(e))?Mg():t=>t}}function Ra(e,t=o_){return e.length?[ei(e,({value:n})=>n===void 0?n:ei(n,t)),bn(e,({value:n})=>n===void 0?n:bn(n,t))]:[0,1]}function MT(e,t){let n=pe.get(e);return(n===ao||n===lo||n===co?IO:Ra)(t)}function IO(e){return[0,e.length?bn(e,({value:t})=>t===void 0?t:bn(t,o_)):1]}function LO(e,t){let n=e.find(({radius:o})=>o!==void 0);if(n!==void 0)return[0,n.radius];let i=Us(e,.5,({value:o})=>o===void 0?NaN:Us(o,.25,no)),r=t.map(o=>3*Math.sqrt(o/i)),s=30/bn(r);return s<1?r.map(o=>o*s):r}function NO(e,t){let n=Uc(e,({value:s})=>s===void 0?NaN:Uc(s,Math.abs)),i=t.map(s=>12*s/n),r=60/bn(i);return r<1?i.map(s=>s*r):i}function DO(e){for(let{value:t}of e)if(t!==void 0)for(let n of t){if(n>0)return Ra(e,no);if(n<0)return Ra(e,_a)}return[1,10]}function UO(e){let t=[];for(let{value:n}of e)if(n!==void 0)for(let i of n)t.push(i);return t}function xl(e){return(t,n)=>i=>e(t+i*(n-t))}var V_=0,H_;function ST(){let e=V_;return V_=0,H_=void 0,e}function Dn(e){e!==H_&&(H_=e,console.warn(e),++V_)}function td(e,t,n,i,{type:r,nice:s,clamp:o,domain:a=Ra(i),unknown:c,pivot:l=0,scheme:u,range:h,symmetric:f=!0,interpolate:d=pe.get(e)===Hn?u==null&&h!==void 0?zs:Ca(u!==void 0?u:"rdbu"):ke,reverse:p}){l=+l,a=er(a);let[_,g]=a;if(a.length>2&&Dn(`Warning: the diverging ${e} scale domain contains extra elements.`),br(_,g)<0&&([_,g]=[g,_],p=!p),_=Math.min(_,l),g=Math.max(g,l),typeof d!="function"&&(d=z_(d)),h!==void 0&&(d=d.length===1?xl(d)(...h):os(d,h)),p&&(d=k_(d)),f){let m=n.apply(l),x=m-n.apply(_),S=n.apply(g)-m;x<S?_=n.invert(m-S):x>S&&(g=n.invert(m+x))}return t.domain([_,l,g]).unknown(c).interpolator(d),o&&t.clamp(o),s&&t.nice(s),{type:r,domain:[_,g],pivot:l,interpolate:d,scale:t}}function wT(e,t,n){return td(e,Rg(),FO,t,n)}function TT(e,t,n){return W_(e,t,{...n,exponent:.5})}function W_(e,t,{exponent:n=1,...i}){return td(e,Lg().exponent(n=+n),kO(n),t,{...i,type:"diverging-pow"})}function AT(e,t,{base:n=10,pivot:i=1,domain:r=Ra(t,i<0?_a:no),...s}){return td(e,Pg().base(n=+n),OO,t,{domain:r,pivot:i,...s})}function ET(e,t,{constant:n=1,...i}){return td(e,Ig().constant(n=+n),zO(n),t,i)}var FO={apply(e){return e},invert(e){return e}},OO={apply:Math.log,invert:Math.exp},BO={apply(e){return Math.sign(e)*Math.sqrt(Math.abs(e))},invert(e){return Math.sign(e)*(e*e)}};function kO(e){return e===.5?BO:{apply(t){return Math.sign(t)*Math.pow(Math.abs(t),e)},invert(t){return Math.sign(t)*Math.pow(Math.abs(t),1/e)}}}function zO(e){return{apply(t){return Math.sign(t)*Math.log1p(Math.abs(t/e))},invert(t){return Math.sign(t)*Math.expm1(Math.abs(t))*e}}}function CT(e,t,n,i){return Pa(e,t,n,i)}function RT(e,t,n){return CT(e,hS(),t,n)}function PT(e,t,n){return CT(e,dS(),t,n)}var Ia=Symbol("ordinal");function LT(e,t,n,{type:i,interval:r,domain:s,range:o,reverse:a,hint:c}){return r=_s(r,i),s===void 0&&(s=OT(n,r,e)),(i==="categorical"||i===Ia)&&(i="ordinal"),a&&(s=jo(s)),s=t.domain(s).domain(),o!==void 0&&(typeof o=="function"&&(o=o(s)),t.range(o)),{type:i,domain:s,range:o,scale:t,hint:c,interval:r}}function NT(e,t,{type:n,interval:i,domain:r,range:s,scheme:o,unknown:a,...c}){i=_s(i,n),r===void 0&&(r=OT(t,i,e));let l;if(pe.get(e)===Ta)l=GO(t),s=s===void 0?VO(l):ye(s,Aa);else if(pe.get(e)===Hn&&(s===void 0&&(n==="ordinal"||n===Ia)&&(s=fT(r,o),s!==void 0&&(o=void 0)),o===void 0&&s===void 0&&(o=n==="ordinal"?"turbo":"observable10"),o!==void 0))if(s!==void 0){let u=Ca(o),h=s[0],f=s[1]-s[0];s=({length:d})=>Mn(p=>u(h+f*p),d)}else s=O_(o);if(a===Sh)throw new Error(`implicit unknown on ${e} scale is not supported`);return LT(e,Th().unknown(a),t,{...c,type:n,domain:r,range:s,hint:l})}function DT(e,t,{align:n=.5,padding:i=.5,...r}){return FT(oS().align(n).padding(i),t,r,e)}function UT(e,t,{align:n=.5,padding:i=.1,paddingInner:r=i,paddingOuter:s=e==="fx"||e==="fy"?0:i,...o}){return FT(pa().align(n).paddingInner(r).paddingOuter(s),t,o,e)}function FT(e,t,n,i){let{round:r}=n;return r!==void 0&&e.round(r=!!r),e=LT(i,e,t,n),e.round=r,e}function OT(e,t,n){let i=new ki;for(let{value:r,domain:s}of e){if(s!==void 0)return s();if(r!==void 0)for(let o of r)i.add(o)}if(t!==void 0){let[r,s]=ni(i).map(t.floor,t);return t.range(r,t.offset(s))}if(i.size>1e4&&pe.get(n)===mi)throw new Error(`implicit ordinal domain of ${n} scale has more than 10,000 values`);return Nc(i,Ln)}function IT(e,t){let n;for(let{hint:i}of e){let r=i?.[t];if(r!==void 0){if(n===void 0)n=r;else if(n!==r)return}}return n}function GO(e){return{fill:IT(e,"fill"),stroke:IT(e,"stroke")}}function VO(e){return tn(e.fill)?kS:BS}function vl(e,{label:t,inset:n=0,insetTop:i=n,insetRight:r=n,insetBottom:s=n,insetLeft:o=n,round:a,nice:c,clamp:l,zero:u,align:h,padding:f,projection:d,facet:{label:p=t}={},..._}={}){let g={};for(let[m,x]of e){let S=_[m],v=$O(m,x,{round:pe.get(m)===mi?a:void 0,nice:c,clamp:l,zero:u,align:h,padding:f,projection:d,...S});if(v){let{label:w=m==="fx"||m==="fy"?p:t,percent:b,transform:y,inset:M,insetTop:R=M!==void 0?M:m==="y"?i:0,insetRight:C=M!==void 0?M:m==="x"?r:0,insetBottom:E=M!==void 0?M:m==="y"?s:0,insetLeft:N=M!==void 0?M:m==="x"?o:0}=S||{};if(y==null)y=void 0;else if(typeof y!="function")throw new Error("invalid scale transform; not a function");v.percent=!!b,v.label=w===void 0?HO(x,v):w,v.transform=y,m==="x"||m==="fx"?(v.insetLeft=+N,v.insetRight=+C):(m==="y"||m==="fy")&&(v.insetTop=+R,v.insetBottom=+E),g[m]=v}}return g}function X_(e){let t={},n={scales:t};for(let[i,r]of Object.entries(e)){let{scale:s,type:o,interval:a,label:c}=r;t[i]=ZO(r),n[i]=s,s.type=o,a!=null&&(s.interval=a),c!=null&&(s.label=c)}return n}function VT(e,t){let{x:n,y:i,fx:r,fy:s}=e,o=r||s?nd(t):t;r&&BT(r,o),s&&kT(s,o);let a=r||s?q_(e,t):t;n&&BT(n,a),i&&kT(i,a)}function HO(e=[],t){let n;for(let{label:i}of e)if(i!==void 0){if(n===void 0)n=i;else if(n!==i)return}if(n!==void 0)return!ir(t)&&t.percent&&(n=`${n} (%)`),{inferred:!0,toString:()=>n}}function HT(e){return Math.sign(Ir(e.domain()))*Math.sign(Ir(e.range()))}function nd(e){let{marginTop:t,marginRight:n,marginBottom:i,marginLeft:r,width:s,height:o,facet:{marginTop:a,marginRight:c,marginBottom:l,marginLeft:u}}=e;return{marginTop:Math.max(t,a),marginRight:Math.max(n,c),marginBottom:Math.max(i,l),marginLeft:Math.max(r,u),width:s,height:o}}function q_({fx:e,fy:t},n){let{marginTop:i,marginRight:r,marginBottom:s,marginLeft:o,width:a,height:c}=nd(n);return{marginTop:i,marginRight:r,marginBottom:s,marginLeft:o,width:e?e.scale.bandwidth()+o+r:a,height:t?t.scale.bandwidth()+i+s:c,facet:{width:a,height:c}}}function BT(e,t){if(e.range===void 0){let{insetLeft:n,insetRight:i}=e,{width:r,marginLeft:s=0,marginRight:o=0}=t,a=s+n,c=r-o-i;e.range=[a,Math.max(a,c)],ir(e)||(e.range=$T(e)),e.scale.range(e.range)}WT(e)}function kT(e,t){if(e.range===void 0){let{insetTop:n,insetBottom:i}=e,{height:r,marginTop:s=0,marginBottom:o=0}=t,a=s+n,c=r-o-i;e.range=[Math.max(a,c),a],ir(e)?e.range.reverse():e.range=$T(e),e.scale.range(e.range)}WT(e)}function WT(e){e.round===void 0&&qO(e)&&WO(e)<=30&&e.scale.round(!0)}function WO({scale:e}){let t=e.domain().length,[n,i]=e.range(),r=e.paddingInner?e.paddingInner():1,s=e.paddingOuter?e.paddingOuter():e.padding(),o=t-r,a=Math.abs(i-n)/Math.max(1,o+s*2);return(a-Math.floor(a))*o}function $T(e){let t=e.scale.domain().length+Y_(e);if(!(t>2))return e.range;let[n,i]=e.range;return Array.from({length:t},(r,s)=>n+s/(t-1)*(i-n))}function $O(e,t=[],n={}){let i=XO(e,t,n);if(n.type===void 0&&n.domain===void 0&&n.range===void 0&&n.interval==null&&e!=="fx"&&e!=="fy"&&ir({type:i})){let r=t.map(({value:s})=>s).filter(s=>s!==void 0);r.some(je)?Dn(`Warning: some data associated with the ${e} scale are dates. Dates are typically associated with a "utc" or "time" scale rather than a "${La(i)}" scale. If you are using a bar mark, you probably want a rect mark with the interval option instead; if you are using a group transform, you probably want a bin transform instead. If you want to treat this data as ordinal, you can specify the interval of the ${e} scale (e.g., d3.utcDay), or you can suppress this warning by setting the type of the ${e} scale to "${La(i)}".`):r.some(Nw)?Dn(`Warning: some data associated with the ${e} scale are strings that appear to be dates (e.g., YYYY-MM-DD). If these strings represent dates, you should parse them to Date objects. Dates are typically associated with a "utc" or "time" scale rather than a "${La(i)}" scale. If you are using a bar mark, you probably want a rect mark with the interval option instead; if you are using a group transform, you probably want a bin transform instead. If you want to treat this data as ordinal, you can suppress this warning by setting the type of the ${e} scale to "${La(i)}".`):r.some(Dw)&&Dn(`Warning: some data associated with the ${e} scale are strings that appear to be numbers. If these strings represent numbers, you should parse or coerce them to numbers. Numbers are typically associated with a "linear" scale rather than a "${La(i)}" scale. If you want to treat this data as ordinal, you can specify the interval of the ${e} scale (e.g., 1 for integers), or you can suppress this warning by setting the type of the ${e} scale to "${La(i)}".`)}switch(n.type=i,i){case"diverging":case"diverging-sqrt":case"diverging-pow":case"diverging-log":case"diverging-symlog":case"cyclical":case"sequential":case"linear":case"sqrt":case"threshold":case"quantile":case"pow":case"log":case"symlog":n=ed(t,n,so);break;case"identity":switch(pe.get(e)){case mi:n=ed(t,n,so);break;case Ta:n=ed(t,n,YO);break}break;case"utc":case"time":n=ed(t,n,v_);break}switch(i){case"diverging":return wT(e,t,n);case"diverging-sqrt":return TT(e,t,n);case"diverging-pow":return W_(e,t,n);case"diverging-log":return AT(e,t,n);case"diverging-symlog":return ET(e,t,n);case"categorical":case"ordinal":case Ia:return NT(e,t,n);case"cyclical":case"sequential":case"linear":return mT(e,t,n);case"sqrt":return gT(e,t,n);case"threshold":return Qh(e,t,n);case"quantile":return xT(e,t,n);case"quantize":return vT(e,t,n);case"pow":return G_(e,t,n);case"log":return _T(e,t,n);case"symlog":return yT(e,t,n);case"utc":return PT(e,t,n);case"time":return RT(e,t,n);case"point":return DT(e,t,n);case"band":return UT(e,t,n);case"identity":return bT(e);case void 0:return;default:throw new Error(`unknown scale type: ${i}`)}}function La(e){return typeof e=="symbol"?e.description:e}function zT(e){return typeof e=="string"?`${e}`.toLowerCase():e}var GT={toString:()=>"projection"};function XO(e,t,{type:n,domain:i,range:r,scheme:s,pivot:o,projection:a}){if(n=zT(n),e==="fx"||e==="fy")return"band";(e==="x"||e==="y")&&a!=null&&(n=GT);for(let u of t){let h=zT(u.type);if(h!==void 0){if(n===void 0)n=h;else if(n!==h)throw new Error(`scale incompatible with channel: ${n} !== ${h}`)}}if(n===GT)return;if(n!==void 0)return n;if(i===void 0&&!t.some(({value:u})=>u!==void 0))return;let c=pe.get(e);if(c===ao)return"sqrt";if(c===lo||c===co)return"linear";if(c===Ta)return"ordinal";let l=(i??r)?.length;if(l<2||l>2)return $_(c);if(i!==void 0){if(E_(i))return $_(c);if(je(i))return"utc"}else{let u=t.map(({value:h})=>h).filter(h=>h!==void 0);if(u.some(E_))return $_(c);if(u.some(je))return"utc"}if(c===Hn){if(o!=null||hT(s))return"diverging";if(uT(s))return"categorical"}return"linear"}function $_(e){switch(e){case mi:return"point";case Hn:return Ia;default:return"ordinal"}}function ir({type:e}){return e==="ordinal"||e==="point"||e==="band"||e===Ia}function Y_({type:e}){return e==="threshold"}function qO({type:e}){return e==="point"||e==="band"}function Ri(e){if(e===void 0)return!0;let t=e.domain(),n=e(t[0]);for(let i=1,r=t.length;i<r;++i)if(e(t[i])-n)return!1;return!0}function ed(e,{domain:t,...n},i){for(let r of e)r.value!==void 0&&(t===void 0&&(t=r.value?.domain),r.value=i(r.value));return{domain:t===void 0?t:i(t),...n}}function YO(e){return ye(e,Aa)}function XT(e){return t=>{if(!pe.has(t=`${t}`))throw new Error(`unknown scale: ${t}`);return e[t]}}function ZO({scale:e,type:t,domain:n,range:i,interpolate:r,interval:s,transform:o,percent:a,pivot:c}){if(t==="identity")return{type:"identity",apply:u=>u,invert:u=>u};let l=e.unknown?e.unknown():void 0;return{type:t,domain:ds(n),...i!==void 0&&{range:ds(i)},...o!==void 0&&{transform:o},...a&&{percent:a},...l!==void 0&&{unknown:l},...s!==void 0&&{interval:s},...r!==void 0&&{interpolate:r},...e.clamp&&{clamp:e.clamp()},...c!==void 0&&{pivot:c,symmetric:!1},...e.base&&{base:e.base()},...e.exponent&&{exponent:e.exponent()},...e.constant&&{constant:e.constant()},...e.align&&{align:e.align(),round:e.round()},...e.padding&&(e.paddingInner?{paddingInner:e.paddingInner(),paddingOuter:e.paddingOuter()}:{padding:e.padding()}),...e.bandwidth&&{bandwidth:e.bandwidth(),step:e.step()},apply:u=>e(u),...e.invert&&{invert:u=>e.invert(u)}}}function YT(e,t){let{fx:n,fy:i}=vl(e,t),r=n?.scale.domain(),s=i?.scale.domain();return r&&s?nb(r,s).map(([o,a],c)=>({x:o,y:a,i:c})):r?r.map((o,a)=>({x:o,i:a})):s?s.map((o,a)=>({y:o,i:a})):void 0}function ZT(e,{x:t,y:n}){return t&&(t=Q_(t)),n&&(n=Q_(n)),e.filter(t&&n?i=>t.has(i.x)&&n.has(i.y):t?i=>t.has(i.x):i=>n.has(i.y)).sort(t&&n?(i,r)=>t.get(i.x)-t.get(r.x)||n.get(i.y)-n.get(r.y):t?(i,r)=>t.get(i.x)-t.get(r.x):(i,r)=>n.get(i.y)-n.get(r.y))}function rd(e,{fx:t,fy:n}){let i=Nn(e),r=t?.value,s=n?.value;return t&&n?is(i,o=>(o.fx=r[o[0]],o.fy=s[o[0]],o),o=>r[o],o=>s[o]):t?is(i,o=>(o.fx=r[o[0]],o),o=>r[o]):is(i,o=>(o.fy=s[o[0]],o),o=>s[o])}function JT(e,t,{marginTop:n,marginLeft:i}){let r=e?({x:o})=>e(o)-i:()=>0,s=t?({y:o})=>t(o)-n:()=>0;return function(o){this.tagName==="svg"?(this.setAttribute("x",r(o)),this.setAttribute("y",s(o))):this.setAttribute("transform",`translate(${r(o)},${s(o)})`)}}function KT(e){let t=[],n=new Uint32Array(zi(e,i=>i.length));for(let i of e){let r=0;for(let s of e)i!==s&&(n.set(s,r),r+=s.length);t.push(n.slice(0,r))}return t}var JO=new Map([["top",Z_],["right",j_],["bottom",J_],["left",K_],["top-left",id(Z_,K_)],["top-right",id(Z_,j_)],["bottom-left",id(J_,K_)],["bottom-right",id(J_,j_)],["top-empty",jO],["right-empty",e4],["bottom-empty",QO],["left-empty",t4],["empty",n4]]);function jT(e){if(e==null)return null;let t=JO.get(`${e}`.toLowerCase());if(t)return t;throw new Error(`invalid facet anchor: ${e}`)}var qT=new WeakMap;function Q_(e){let t=qT.get(e);return t||qT.set(e,t=new ti(ye(e,(n,i)=>[n,i]))),t}function vs(e,t){return Q_(e).get(t)}function KO(e,t,n){return t=di(t),n=di(n),e.find(i=>Object.is(di(i.x),t)&&Object.is(di(i.y),n))}function sd(e,t,n){return KO(e,t,n)?.empty}function Z_(e,{y:t},{y:n}){return t?vs(t,n)===0:!0}function J_(e,{y:t},{y:n}){return t?vs(t,n)===t.length-1:!0}function K_(e,{x:t},{x:n}){return t?vs(t,n)===0:!0}function j_(e,{x:t},{x:n}){return t?vs(t,n)===t.length-1:!0}function jO(e,{y:t},{x:n,y:i,empty:r}){if(r)return!1;if(!t)return;let s=vs(t,i);if(s>0)return sd(e,n,t[s-1])}function QO(e,{y:t},{x:n,y:i,empty:r}){if(r)return!1;if(!t)return;let s=vs(t,i);if(s<t.length-1)return sd(e,n,t[s+1])}function t4(e,{x:t},{x:n,y:i,empty:r}){if(r)return!1;if(!t)return;let s=vs(t,n);if(s>0)return sd(e,t[s-1],i)}function e4(e,{x:t},{x:n,y:i,empty:r}){if(r)return!1;if(!t)return;let s=vs(t,n);if(s<t.length-1)return sd(e,t[s+1],i)}function n4(e,t,{empty:n}){return n}function id(e,t){return function(){return e.apply(null,arguments)&&t.apply(null,arguments)}}function od(e,{channels:{fx:t,fy:n},groups:i}){return t&&n?e.map(({x:r,y:s})=>i.get(r)?.get(s)??[]):t?e.map(({x:r})=>i.get(r)??[]):e.map(({y:r})=>i.get(r)??[])}var QT=Math.PI,Br=2*QT,ty=.618;function tA({projection:e,inset:t=0,insetTop:n=t,insetRight:i=t,insetBottom:r=t,insetLeft:s=t}={},o){if(e==null)return;if(typeof e.stream=="function")return e;let a,c,l="frame";if(nr(e)){let w;if({type:e,domain:c,inset:w,insetTop:n=w!==void 0?w:n,insetRight:i=w!==void 0?w:i,insetBottom:r=w!==void 0?w:r,insetLeft:s=w!==void 0?w:s,clip:l=l,...a}=e,e==null)return}typeof e!="function"&&({type:e}=ey(e));let{width:u,height:h,marginLeft:f,marginRight:d,marginTop:p,marginBottom:_}=o,g=u-f-d-s-i,m=h-p-_-n-r;if(e=e?.({width:g,height:m,clip:l,...a}),e==null)return;l=i4(l,f,p,u-d,h-_);let x=f+s,S=p+n,v;if(c!=null){let[[w,b],[y,M]]=Qc(e).bounds(c),R=Math.min(g/(y-w),m/(M-b));R>0?(x-=(R*(w+y)-g)/2,S-=(R*(b+M)-m)/2,v=tl({point(C,E){this.stream.point(C*R+x,E*R+S)}})):Dn("Warning: the projection could not be fit to the specified domain; using the default scale.")}return v??(v=x===0&&S===0?eA():tl({point(w,b){this.stream.point(w+x,b+S)}})),{stream:w=>e.stream(v.stream(l(w)))}}function ey(e){switch(`${e}`.toLowerCase()){case"albers-usa":return Pi(lM,.7463,.4673);case"albers":return ad(sg,.7463,.4673);case"azimuthal-equal-area":return Pi(hM,4,4);case"azimuthal-equidistant":return Pi(pM,Br,Br);case"conic-conformal":return ad(_M,Br,Br);case"conic-equal-area":return ad(jc,6.1702,2.9781);case"conic-equidistant":return ad(xM,7.312,3.6282);case"equal-earth":return Pi(bM,5.4133,2.6347);case"equirectangular":return Pi(yM,Br,QT);case"gnomonic":return Pi(SM,3.4641,3.4641);case"identity":return{type:eA};case"reflect-y":return{type:r4};case"mercator":return Pi(mM,Br,Br);case"orthographic":return Pi(TM,2,2);case"stereographic":return Pi(EM,2,2);case"transverse-mercator":return Pi(RM,Br,Br);default:throw new Error(`unknown projection type: ${e}`)}}function i4(e,t,n,i,r){if(e===!1||e==null||typeof e=="number")return s=>s;if(e===!0&&(e="frame"),`${e}`.toLowerCase()==="frame")return eg(t,n,i,r);throw new Error(`unknown projection clip type: ${e}`)}function Pi(e,t,n){return{type:({width:i,height:r,rotate:s,precision:o=.15,clip:a})=>{let c=e();return o!=null&&c.precision?.(o),s!=null&&c.rotate?.(s),typeof a=="number"&&c.clipAngle?.(a),i!=null&&(c.scale(Math.min(i/t,r/n)),c.translate([i/2,r/2])),c},aspectRatio:n/t}}function ad(e,t,n){let{type:i,aspectRatio:r}=Pi(e,t,n);return{type:s=>{let{parallels:o,domain:a,width:c,height:l}=s,u=i(s);return o!=null&&(u.parallels(o),a===void 0&&c!=null&&u.fitSize([c,l],{type:"Sphere"})),u},aspectRatio:r}}var eA=Vn({stream:e=>e}),r4=Vn(tl({point(e,t){this.stream.point(e,-t)}}));function nA(e,t,n,i){let r=n[e],s=n[t],o=r.length,a=n[e]=new Float64Array(o).fill(NaN),c=n[t]=new Float64Array(o).fill(NaN),l,u=i.stream({point(h,f){a[l]=h,c[l]=f}});for(l=0;l<o;++l)u.point(r[l],s[l])}function iA({projection:e}={}){return e==null?!1:typeof e.stream=="function"?!0:(nr(e)&&(e=e.type),e!=null)}function rA(e){if(typeof e?.stream=="function")return ty;if(nr(e)){let t,n;if({domain:t,type:e,...n}=e,t!=null&&e!=null){let i=typeof e=="string"?ey(e).type:e,[[r,s],[o,a]]=Qc(i({...n,width:100,height:100})).bounds(t),c=(a-s)/(o-r);return c&&isFinite(c)?c<.2?.2:c>5?5:c:ty}}if(e!=null){if(typeof e!="function"){let{aspectRatio:t}=ey(e);if(t)return t}return ty}}function sA(e){let t=[],n=[],i={scale:"x",value:t},r={scale:"y",value:n},s={point(o,a){t.push(o),n.push(a)},lineStart(){},lineEnd(){},polygonStart(){},polygonEnd(){},sphere(){}};for(let o of e.value)as(o,s);return[i,r]}function oA({x:e,y:t}){if(e||t)return e??(e=n=>n),t??(t=n=>n),tl({point(n,i){this.stream.point(e(n),t(i))}})}function Na(e={}){let{document:t=typeof window<"u"?window.document:void 0,clip:n}=e;return{document:t,clip:jh(n)}}function ae(e,{document:t}){return Ti(Qo(e).call(t.documentElement))}var cd=Symbol("unset");function ld(e){return(e.length===1?s4:o4)(e)}function s4(e){let t,n=cd;return i=>(Object.is(n,i)||(n=i,t=e(i)),t)}function o4(e){let t,n;return(...i)=>((n?.length!==i.length||n.some((r,s)=>!Object.is(r,i[s])))&&(n=i,t=e(...i)),t)}var a4=ld(e=>new Intl.NumberFormat(e)),U7=ld((e,t)=>new Intl.DateTimeFormat(e,{timeZone:"UTC",...t&&{month:t}})),F7=ld((e,t)=>new Intl.DateTimeFormat(e,{timeZone:"UTC",...t&&{weekday:t}}));function c4(e="en-US"){let t=a4(e);return n=>n!=null&&!isNaN(n)?t.format(n):void 0}function l4(e){return Vh(e,"Invalid Date")}function u4(e="en-US"){let t=c4(e);return n=>(n instanceof Date?l4:typeof n=="number"?t:Pe)(n)}var rr=u4();var cn=(typeof window<"u"?window.devicePixelRatio>1:typeof it>"u")?0:.5,f4=0;function cA(){return`plot-clip-${++f4}`}function lA(e,{title:t,href:n,ariaLabel:i,ariaDescription:r,ariaHidden:s,target:o,fill:a,fillOpacity:c,stroke:l,strokeWidth:u,strokeOpacity:h,strokeLinejoin:f,strokeLinecap:d,strokeMiterlimit:p,strokeDasharray:_,strokeDashoffset:g,opacity:m,mixBlendMode:x,imageFilter:S,paintOrder:v,pointerEvents:w,shapeRendering:b,channels:y},{ariaLabel:M,fill:R="currentColor",fillOpacity:C,stroke:E="none",strokeOpacity:N,strokeWidth:k,strokeLinecap:P,strokeLinejoin:L,strokeMiterlimit:B,paintOrder:U}){R===null&&(a=null,c=null),E===null&&(l=null,h=null),tn(R)?!tn(E)&&(!tn(a)||y?.fill)&&(E="none"):tn(E)&&(!tn(l)||y?.stroke)&&(R="none");let[Z,F]=tr(a,R),[G,q]=Ce(c,C),[rt,ct]=tr(l,E),[$,ot]=Ce(h,N),[ut,st]=Ce(m);oo(ct)||(u===void 0&&(u=k),d===void 0&&(d=P),f===void 0&&(f=L),p===void 0&&!Ow(f)&&(p=B),!oo(F)&&v===void 0&&(v=U));let[at,J]=Ce(u);return R!==null&&(e.fill=Re(F,"currentColor"),e.fillOpacity=bl(q,1)),E!==null&&(e.stroke=Re(ct,"none"),e.strokeWidth=bl(J,1),e.strokeOpacity=bl(ot,1),e.strokeLinejoin=Re(f,"miter"),e.strokeLinecap=Re(d,"butt"),e.strokeMiterlimit=bl(p,4),e.strokeDasharray=Re(_,"none"),e.strokeDashoffset=Re(g,"0")),e.target=Pe(o),e.ariaLabel=Pe(M),e.ariaDescription=Pe(r),e.ariaHidden=Pe(s),e.opacity=bl(st,1),e.mixBlendMode=Re(x,"normal"),e.imageFilter=Re(S,"none"),e.paintOrder=Re(v,"normal"),e.pointerEvents=Re(w,"auto"),e.shapeRendering=Re(b,"auto"),{title:{value:t,optional:!0,filter:null},href:{value:n,optional:!0,filter:null},ariaLabel:{value:i,optional:!0,filter:null},fill:{value:Z,scale:"auto",optional:!0},fillOpacity:{value:G,scale:"auto",optional:!0},stroke:{value:rt,scale:"auto",optional:!0},strokeOpacity:{value:$,scale:"auto",optional:!0},strokeWidth:{value:at,optional:!0},opacity:{value:ut,scale:"auto",optional:!0}}}function h4(e,t){t&&e.filter(n=>dl(t[n])).append("title").call(p4,t)}function d4(e,t){t&&e.filter(([n])=>dl(t[n])).append("title").call(m4,t)}function p4(e,t){t&&e.text(n=>rr(t[n]))}function m4(e,t){t&&e.text(([n])=>rr(t[n]))}function ln(e,{target:t,tip:n},{ariaLabel:i,title:r,fill:s,fillOpacity:o,stroke:a,strokeOpacity:c,strokeWidth:l,opacity:u,href:h}){i&&Bt(e,"aria-label",f=>i[f]),s&&Bt(e,"fill",f=>s[f]),o&&Bt(e,"fill-opacity",f=>o[f]),a&&Bt(e,"stroke",f=>a[f]),c&&Bt(e,"stroke-opacity",f=>c[f]),l&&Bt(e,"stroke-width",f=>l[f]),u&&Bt(e,"opacity",f=>u[f]),h&&hA(e,f=>h[f],t),n||h4(e,r)}function uA(e,{target:t,tip:n},{ariaLabel:i,title:r,fill:s,fillOpacity:o,stroke:a,strokeOpacity:c,strokeWidth:l,opacity:u,href:h}){i&&Bt(e,"aria-label",([f])=>i[f]),s&&Bt(e,"fill",([f])=>s[f]),o&&Bt(e,"fill-opacity",([f])=>o[f]),a&&Bt(e,"stroke",([f])=>a[f]),c&&Bt(e,"stroke-opacity",([f])=>c[f]),l&&Bt(e,"stroke-width",([f])=>l[f]),u&&Bt(e,"opacity",([f])=>u[f]),h&&hA(e,([f])=>h[f],t),n||d4(e,r)}function g4({ariaLabel:e,title:t,fill:n,fillOpacity:i,stroke:r,strokeOpacity:s,strokeWidth:o,opacity:a,href:c},{tip:l}){return[e,l?void 0:t,n,i,r,s,o,a,c].filter(u=>u!==void 0)}function _4(e,t,n){let i=Zo(e,r=>t[r]);return n===void 0&&i.size>1+e.length>>1&&Dn("Warning: the implicit z channel has high cardinality. This may occur when the fill or stroke channel is associated with quantitative data rather than ordinal or categorical data. You can suppress this warning by setting the z option explicitly; if this data represents a single series, set z to null."),i.values()}function*fA(e,t,n,i){let{z:r}=n,{z:s}=i,o=g4(i,n),a=[...t,...o];for(let c of s?_4(e,s,r):[e]){let l,u;t:for(let h of c){for(let f of a)if(!hi(f[h])){u&&u.push(-1);continue t}if(l===void 0){u&&(yield u),l=o.map(f=>di(f[h])),u=[h];continue}u.push(h);for(let f=0;f<o.length;++f)if(di(o[f][h])!==l[f]){yield u,l=o.map(p=>di(p[h])),u=[h];continue t}}u&&(yield u)}}function y4(e,t,n,i){let r,{clip:s=i.clip}=t;s==="frame"?(e=ae("svg:g",i).each(function(){this.appendChild(e.node()),e.node=()=>this}),r=v4(i,n)):s&&(r=M4(s,i)),Bt(e,"aria-label",t.ariaLabel),Bt(e,"aria-description",t.ariaDescription),Bt(e,"aria-hidden",t.ariaHidden),Bt(e,"clip-path",r)}function x4(e){let t=new WeakMap;return(n,i)=>{let r=t.get(n);if(!r){let s=cA();Ti(n.ownerSVGElement).append("clipPath").attr("id",s).call(e,n,i),t.set(n,r=`url(#${s})`)}return r}}var v4=x4((e,t,n)=>{let{width:i,height:r,marginLeft:s,marginRight:o,marginTop:a,marginBottom:c}=n;e.append("rect").attr("x",s).attr("y",a).attr("width",i-o-s).attr("height",r-a-c)}),aA=new WeakMap,b4={type:"Sphere"};function M4(e,t){let n,i;if((n=aA.get(t))||aA.set(t,n=new WeakMap),e.type==="Sphere"&&(e=b4),!(i=n.get(e))){let r=cA();Ti(t.ownerSVGElement).append("clipPath").attr("id",r).append("path").attr("d",t.path()(e)),n.set(e,i=`url(#${r})`)}return i}function Ve(e,t,n,i){y4(e,t,n,i),Bt(e,"class",t.className),Bt(e,"fill",t.fill),Bt(e,"fill-opacity",t.fillOpacity),Bt(e,"stroke",t.stroke),Bt(e,"stroke-width",t.strokeWidth),Bt(e,"stroke-opacity",t.strokeOpacity),Bt(e,"stroke-linejoin",t.strokeLinejoin),Bt(e,"stroke-linecap",t.strokeLinecap),Bt(e,"stroke-miterlimit",t.strokeMiterlimit),Bt(e,"stroke-dasharray",t.strokeDasharray),Bt(e,"stroke-dashoffset",t.strokeDashoffset),Bt(e,"shape-rendering",t.shapeRendering),Bt(e,"filter",t.imageFilter),Bt(e,"paint-order",t.paintOrder);let{pointerEvents:r=i.pointerSticky===!1?"none":void 0}=t;Bt(e,"pointer-events",r)}function Le(e,t){S4(e,"mix-blend-mode",t.mixBlendMode),Bt(e,"opacity",t.opacity)}function hA(e,t,n){e.each(function(i){let r=t(i);if(r!=null){let s=this.ownerDocument.createElementNS(rs.svg,"a");s.setAttribute("fill","inherit"),s.setAttributeNS(rs.xlink,"href",r),n!=null&&s.setAttribute("target",n),this.parentNode.insertBefore(s,this).appendChild(this)}})}function Bt(e,t,n){n!=null&&e.attr(t,n)}function S4(e,t,n){n!=null&&e.style(t,n)}function He(e,t,{x:n,y:i},r=cn,s=cn){r+=t.dx,s+=t.dy,n?.bandwidth&&(r+=n.bandwidth()/2),i?.bandwidth&&(s+=i.bandwidth()/2),(r||s)&&e.attr("transform",`translate(${r},${s})`)}function Re(e,t){if((e=Pe(e))!==t)return e}function bl(e,t){if((e=Ie(e))!==t)return e}var w4=/^-?([_a-z]|[\240-\377]|\\[0-9a-f]{1,6}(\r\n|[ \t\r\n\f])?|\\[^\r\n\f0-9a-f])([_a-z0-9-]|[\240-\377]|\\[0-9a-f]{1,6}(\r\n|[ \t\r\n\f])?|\\[^\r\n\f0-9a-f])*$/i;function Da(e){if(e===void 0)return"plot-d6a7b5";if(e=`${e}`,!w4.test(e))throw new Error(`invalid class name: ${e}`);return e}function Ua(e,t){if(typeof t=="string")e.property("style",t);else if(t!=null)for(let n of e)Object.assign(n.style,t)}function sr({frameAnchor:e},{width:t,height:n,marginTop:i,marginRight:r,marginBottom:s,marginLeft:o}){return[/left$/.test(e)?o:/right$/.test(e)?t-r:(o+t-r)/2,/^top/.test(e)?i:/^bottom/.test(e)?n-s:(i+n-s)/2]}var xe=class{constructor(t,n={},i={},r){let{facet:s="auto",facetAnchor:o,fx:a,fy:c,sort:l,dx:u=0,dy:h=0,margin:f=0,marginTop:d=f,marginRight:p=f,marginBottom:_=f,marginLeft:g=f,className:m,clip:x=r?.clip,channels:S,tip:v,render:w}=i;if(this.data=t,this.sort=ps(l)?l:null,this.initializer=Dr(i).initializer,this.transform=this.initializer?i.transform:_l(i).transform,s===null||s===!1?this.facet=null:(this.facet=Tn(s===!0?"include":s,"facet",["auto","include","exclude","super"]),this.fx=t===ba&&typeof a=="string"?[a]:a,this.fy=t===ba&&typeof c=="string"?[c]:c),this.facetAnchor=jT(o),n=C_(n),S!==void 0&&(n={...T4(S),...n}),r!==void 0&&(n={...lA(this,i,r),...n}),this.channels=Object.fromEntries(Object.entries(n).map(([b,y])=>{if(Sa(y.value)){let{value:M,label:R=y.label,scale:C=y.scale}=y.value;y={...y,label:R,scale:C,value:M}}if(t===ba&&typeof y.value=="string"){let{value:M}=y;y={...y,value:[M]}}return[b,y]}).filter(([b,{value:y,optional:M}])=>{if(y!=null)return!0;if(M)return!1;throw new Error(`missing channel value: ${b}`)})),this.dx=+u,this.dy=+h,this.marginTop=+d,this.marginRight=+p,this.marginBottom=+_,this.marginLeft=+g,this.clip=jh(x),this.tip=A4(v),this.className=Pe(m),this.facet==="super"){if(a||c)throw new Error("super-faceting cannot use fx or fy");for(let b in this.channels){let{scale:y}=n[b];if(!(y!=="x"&&y!=="y"))throw new Error("super-faceting cannot use x or y")}}w!=null&&(this.render=iy(w,this.render))}initialize(t,n,i){let r=Lr(this.data);t===void 0&&r!=null&&(t=[Nn(r)]);let s=t;this.transform!=null&&({facets:t,data:r}=this.transform(r,t,i),r=Lr(r)),t!==void 0&&(t.original=s);let o=tT(this.channels,r);return this.sort!=null&&nT(r,t,o,n,this.sort),{data:r,facets:t,channels:o}}filter(t,n,i){for(let r in n){let{filter:s=hi}=n[r];if(s!==null){let o=i[r];t=t.filter(a=>s(o[a]))}}return t}project(t,n,i){for(let r in t)if(t[r].scale==="x"&&/^x|x$/.test(r)){let s=r.replace(/^x|x$/,"y");s in t&&t[s].scale==="y"&&nA(r,s,n,i.projection)}}scale(t,n,i){let r=eT(t,n);return i.projection&&this.project(t,r,i),r}};function ny(...e){return e.plot=xe.prototype.plot,e}function iy(e,t){if(e==null)return t===null?void 0:t;if(t==null)return e===null?void 0:e;if(typeof e!="function")throw new TypeError(`invalid render transform: ${e}`);if(typeof t!="function")throw new TypeError(`invalid render transform: ${t}`);return function(n,i,r,s,o,a){return e.call(this,n,i,r,s,o,(c,l,u,h,f)=>t.call(this,c,l,u,h,f,a))}}function T4(e){return Object.fromEntries(Object.entries(C_(e)).map(([t,n])=>(n=typeof n=="string"?{value:n,label:t}:ys(n),n.filter===void 0&&n.scale==null&&(n={...n,filter:null}),[t,n])))}function A4(e){return e===!0?"xy":e===!1||e==null?null:typeof e=="string"?Tn(e,"tip",["x","y","xy"]):e}function Fa(e,t){return e?.tip===!0?{...e,tip:t}:nr(e?.tip)&&e.tip.pointer===void 0?{...e,tip:{...e.tip,pointer:t}}:e}function pA(e,t,n={}){let i=.5-cn,r=.5+cn,s=.5+cn,o=.5-cn;for(let{marginTop:_,marginRight:g,marginBottom:m,marginLeft:x}of t)_>i&&(i=_),g>r&&(r=g),m>s&&(s=m),x>o&&(o=x);let{margin:a,marginTop:c=a!==void 0?a:i,marginRight:l=a!==void 0?a:r,marginBottom:u=a!==void 0?a:s,marginLeft:h=a!==void 0?a:o}=n;c=+c,l=+l,u=+u,h=+h;let{width:f=640,height:d=E4(e,n,{width:f,marginTopDefault:i,marginRightDefault:r,marginBottomDefault:s,marginLeftDefault:o})+Math.max(0,c-i+u-s)}=n;f=+f,d=+d;let p={width:f,height:d,marginTop:c,marginRight:l,marginBottom:u,marginLeft:h};if(e.fx||e.fy){let{margin:_,marginTop:g=_!==void 0?_:c,marginRight:m=_!==void 0?_:l,marginBottom:x=_!==void 0?_:u,marginLeft:S=_!==void 0?_:h}=n.facet??{};g=+g,m=+m,x=+x,S=+S,p.facet={marginTop:g,marginRight:m,marginBottom:x,marginLeft:S}}return p}function E4({x:e,y:t,fy:n,fx:i},{projection:r,aspectRatio:s},{width:o,marginTopDefault:a,marginRightDefault:c,marginBottomDefault:l,marginLeftDefault:u}){let h=n&&n.scale.domain().length||1,f=rA(r);if(f){let p=i?i.scale.domain().length:1,_=(1.1*h-.1)/(1.1*p-.1)*f,g=Math.max(.1,Math.min(10,_));return Math.round((o-u-c)*g+a+l)}let d=t?ir(t)?t.scale.domain().length||1:Math.max(7,17/h):1;if(s!=null){if(s=+s,!(isFinite(s)&&s>0))throw new Error(`invalid aspectRatio: ${s}`);let p=dA("y",t)/(dA("x",e)*s),_=i?i.scale.bandwidth():1,g=n?n.scale.bandwidth():1,m=_*(o-u-c)-e.insetLeft-e.insetRight;return(p*m+t.insetTop+t.insetBottom)/g+a+l}return!!(t||n)*Math.max(1,Math.min(60,d*h))*20+!!i*30+60}function dA(e,t){if(!t)throw new Error(`aspectRatio requires ${e} scale`);let{type:n,domain:i}=t,r;switch(n){case"linear":case"utc":case"time":r=Number;break;case"pow":{let a=t.scale.exponent();r=c=>Math.pow(c,a);break}case"log":r=Math.log;break;case"point":case"band":return i.length;default:throw new Error(`unsupported ${e} scale for aspectRatio: ${n}`)}let[s,o]=ni(i);return Math.abs(r(o)-r(s))}var mA=new WeakMap;function ry(e,t,{x:n,y:i,px:r,py:s,maxRadius:o=40,channels:a,render:c,...l}={}){return o=+o,r!=null&&(n??(n=null),a={...a,px:{value:r,scale:"x"}}),s!=null&&(i??(i=null),a={...a,py:{value:s,scale:"y"}}),{x:n,y:i,channels:a,...l,render:iy(function(u,h,f,d,p,_){p={...p,pointerSticky:!1};let g=p.ownerSVGElement,{data:m}=p.getMarkState(this),x=mA.get(g);x||mA.set(g,x={sticky:!1,roots:[],renders:[]});let S=x.renders.push(ct)-1,{x:v,y:w,fx:b,fy:y}=h,M=b?b(u.fx)-d.marginLeft:0,R=y?y(u.fy)-d.marginTop:0;v?.bandwidth&&(M+=v.bandwidth()/2),w?.bandwidth&&(R+=w.bandwidth()/2);let C=u.fi!=null,E;if(C){let st=x.facetStates;st||(x.facetStates=st=new Map),E=st.get(this),E||st.set(this,E=new Map)}let[N,k]=sr(this,d),{px:P,py:L}=f,B=P?st=>P[st]:oy(f,N),U=L?st=>L[st]:ay(f,k),Z,F,G,q;function rt(st,at){if(C)if(q&&(q=cancelAnimationFrame(q)),st==null)E.delete(u.fi);else{E.set(u.fi,at),q=requestAnimationFrame(()=>{q=null;for(let[J,yt]of E)if(yt<at||yt===at&&J<u.fi){st=null;break}ct(st)});return}ct(st)}function ct(st){if(Z===st&&G===x.sticky)return;Z=st,G=p.pointerSticky=x.sticky;let at=Z==null?[]:[Z];C&&(at.fx=u.fx,at.fy=u.fy,at.fi=u.fi);let J=_(at,h,f,d,p);if(F){if(C){let yt=F.parentNode,lt=F.getAttribute("transform"),K=J.getAttribute("transform");lt?J.setAttribute("transform",lt):J.removeAttribute("transform"),K?yt.setAttribute("transform",K):yt.removeAttribute("transform"),J.removeAttribute("aria-label"),J.removeAttribute("aria-description"),J.removeAttribute("aria-hidden")}F.replaceWith(J)}if(x.roots[S]=F=J,!(Z==null&&E?.size>1)){let yt=Z==null?null:Ci(m)?m[Z]:m.get(Z);p.dispatchValue(yt)}return J}function $(st){if(x.sticky||st.pointerType==="mouse"&&st.buttons===1)return;let[at,J]=Pb(st);at-=M,J-=R;let yt=at<d.marginLeft||at>d.width-d.marginRight?1:e,lt=J<d.marginTop||J>d.height-d.marginBottom?1:t,K=null,Lt=o*o;for(let Mt of u){let Vt=yt*(B(Mt)-at),Xt=lt*(U(Mt)-J),he=Vt*Vt+Xt*Xt;he<=Lt&&(K=Mt,Lt=he)}if(K!=null&&(e!==1||t!==1)){let Mt=B(K)-at,Vt=U(K)-J;Lt=Mt*Mt+Vt*Vt}rt(K,Lt)}function ot(st){st.pointerType==="mouse"&&Z!=null&&(x.sticky&&x.roots.some(at=>at?.contains(st.target))||(x.sticky?(x.sticky=!1,x.renders.forEach(at=>at(null))):(x.sticky=!0,ct(Z)),st.stopImmediatePropagation()))}function ut(st){st.pointerType==="mouse"&&(x.sticky||rt(null))}return g.addEventListener("pointerenter",$),g.addEventListener("pointermove",$),g.addEventListener("pointerdown",ot),g.addEventListener("pointerleave",ut),ct(null)},c)}}function Ml(e){return ry(1,1,e)}function sy(e){return ry(1,.01,e)}function ud(e){return ry(.01,1,e)}function oy({x1:e,x2:t,x:n=e},i){return e&&t?r=>(e[r]+t[r])/2:n?r=>n[r]:()=>i}function ay({y1:e,y2:t,y:n=e},i){return e&&t?r=>(e[r]+t[r])/2:n?r=>n[r]:()=>i}function fd(e){return ir(e)&&e.interval===void 0?void 0:"tabular-nums"}function gA(e,t){let{label:n=e.label,tickSize:i=6,width:r=240,height:s=44+i,marginTop:o=18,marginRight:a=0,marginBottom:c=16+i,marginLeft:l=0,style:u,ticks:h=(r-l-a)/64,tickFormat:f,fontVariant:d=fd(e),round:p=!0,opacity:_,className:g}=t,m=Na(t);g=Da(g),_=Ce(_)[1],f===null&&(f=()=>null);let x=ae("svg",m).attr("class",`${g}-ramp`).attr("font-family","system-ui, sans-serif").attr("font-size",10).attr("width",r).attr("height",s).attr("viewBox",`0 0 ${r} ${s}`).call(N=>N.append("style").text(`:where(.${g}-ramp) {
  display: block;
  height: auto;
  height: intrinsic;
  max-width: 100%;
  overflow: visible;
}
:where(.${g}-ramp text) {
  white-space: pre;
}`)).call(Ua,u),S=N=>N.selectAll(".tick line").attr("y1",o+c-s),v,w=p?(N,k)=>N.rangeRound(k):(N,k)=>N.range(k),{type:b,domain:y,range:M,interpolate:R,scale:C,pivot:E}=e;if(R){let N=M===void 0?R:os(R.length===1?xl(R):R,M);v=w(C.copy(),Mn(ke(l,r-a),Math.min(y.length+(E!==void 0),M===void 0?1/0:M.length)));let k=256,P=m.document.createElement("canvas");P.width=k,P.height=1;let L=P.getContext("2d");for(let B=0,U=k-1;B<k;++B)L.fillStyle=N(B/U),L.fillRect(B,0,1,1);x.append("image").attr("opacity",_).attr("x",l).attr("y",o).attr("width",r-l-a).attr("height",s-o-c).attr("preserveAspectRatio","none").attr("xlink:href",P.toDataURL())}else if(b==="threshold"){let N=y,k=f===void 0?P=>P:typeof f=="string"?Wi(f):f;v=w(ll().domain([-1,M.length-1]),[l,r-a]),x.append("g").attr("fill-opacity",_).selectAll().data(M).enter().append("rect").attr("x",(P,L)=>v(L-1)).attr("y",o).attr("width",(P,L)=>v(L)-v(L-1)).attr("height",s-o-c).attr("fill",P=>P),h=ye(N,(P,L)=>L),f=P=>k(N[P],P)}else v=w(pa().domain(y),[l,r-a]),x.append("g").attr("fill-opacity",_).selectAll().data(y).enter().append("rect").attr("x",v).attr("y",o).attr("width",Math.max(0,v.bandwidth()-1)).attr("height",s-o-c).attr("fill",C),S=()=>{};return x.append("g").attr("transform",`translate(0,${s-c})`).call(yb(v).ticks(Array.isArray(h)?null:h,typeof f=="string"?f:void 0).tickFormat(typeof f=="function"?f:void 0).tickSize(i).tickValues(Array.isArray(h)?h:null)).attr("font-size",null).attr("font-family",null).attr("font-variant",Re(d,"normal")).call(S).call(N=>N.select(".domain").remove()),n!==void 0&&x.append("text").attr("x",l).attr("y",o-6).attr("fill","currentColor").attr("font-weight","bold").text(n),x.node()}var cy=Math.PI/180;function Sl(e,{marker:t,markerStart:n=t,markerMid:i=t,markerEnd:r=t}={}){e.markerStart=ly(n),e.markerMid=ly(i),e.markerEnd=ly(r)}function ly(e){if(e==null||e===!1)return null;if(e===!0)return yA;if(typeof e=="function")return e;switch(`${e}`.toLowerCase()){case"none":return null;case"arrow":return _A("auto");case"arrow-reverse":return _A("auto-start-reverse");case"dot":return C4;case"circle":case"circle-fill":return yA;case"circle-stroke":return R4;case"tick":return uy("auto");case"tick-x":return uy(90);case"tick-y":return uy(0)}throw new Error(`invalid marker: ${e}`)}function _A(e){return(t,n)=>ae("svg:marker",n).attr("viewBox","-5 -5 10 10").attr("markerWidth",6.67).attr("markerHeight",6.67).attr("orient",e).attr("fill","none").attr("stroke",t).attr("stroke-width",1.5).attr("stroke-linecap","round").attr("stroke-linejoin","round").call(i=>i.append("path").attr("d","M-1.5,-3l3,3l-3,3")).node()}function C4(e,t){return ae("svg:marker",t).attr("viewBox","-5 -5 10 10").attr("markerWidth",6.67).attr("markerHeight",6.67).attr("fill",e).attr("stroke","none").call(n=>n.append("circle").attr("r",2.5)).node()}function yA(e,t){return ae("svg:marker",t).attr("viewBox","-5 -5 10 10").attr("markerWidth",6.67).attr("markerHeight",6.67).attr("fill",e).attr("stroke","var(--plot-background)").attr("stroke-width",1.5).call(n=>n.append("circle").attr("r",3)).node()}function R4(e,t){return ae("svg:marker",t).attr("viewBox","-5 -5 10 10").attr("markerWidth",6.67).attr("markerHeight",6.67).attr("fill","var(--plot-background)").attr("stroke",e).attr("stroke-width",1.5).call(n=>n.append("circle").attr("r",3)).node()}function uy(e){return(t,n)=>ae("svg:marker",n).attr("viewBox","-3 -3 6 6").attr("markerWidth",6).attr("markerHeight",6).attr("orient",e).attr("stroke",t).call(i=>i.append("path").attr("d","M0,-3v6")).node()}var P4=0;function hy(e,t,{stroke:n},i){return bA(e,t,n&&(r=>n[r]),null,i)}function xA(e,t,{stroke:n,z:i},r){return bA(e,t,n&&(([s])=>n[s]),i,r)}var fy=1,vA=2;function I4(e,t){let n=new Uint8Array(t.length),i=e.data().filter(s=>s.length>1),r=i.length;for(let s=0,o=cd;s<r;++s){let a=i[s];if(a.length>1){let c=a[0];o!==(o=di(t[c]))&&(n[c]|=fy)}}for(let s=r-1,o=cd;s>=0;--s){let a=i[s];if(a.length>1){let c=a[0];o!==(o=di(t[c]))&&(n[c]|=vA)}}return([s])=>n[s]}function bA(e,{markerStart:t,markerMid:n,markerEnd:i,stroke:r},s=()=>r,o,a){if(!t&&!n&&!i)return;let c=new Map,l=o&&I4(e,o);function u(h,f,d){return function(p){if(d&&!d(p))return;let _=s(p),g=c.get(f);g||c.set(f,g=new Map);let m=g.get(_);if(!m){let x=this.parentNode.insertBefore(f(_,a),this),S=`plot-marker-${++P4}`;x.setAttribute("id",S),g.set(_,m=`url(#${S})`)}this.setAttribute(h,m)}}t&&e.each(u("marker-start",t,l&&(h=>l(h)&fy))),n&&l&&e.each(u("marker-start",n,h=>!(l(h)&fy))),n&&e.each(u("marker-mid",n)),i&&e.each(u("marker-end",i,l&&(h=>l(h)&vA)))}function hd({inset:e,insetLeft:t,insetRight:n,...i}={}){return[t,n]=MA(e,t,n),{inset:e,insetLeft:t,insetRight:n,...i}}function dy({inset:e,insetTop:t,insetBottom:n,...i}={}){return[t,n]=MA(e,t,n),{inset:e,insetTop:t,insetBottom:n,...i}}function MA(e,t,n){return e===void 0&&t===void 0&&n===void 0?cn?[1,0]:[.5,.5]:[t,n]}function SA(e,{interval:t}){return e={...ys(e)},e.interval=Yh(e.interval===void 0?t:e.interval),e}function py(e,t,n,i){let{[e]:r,[`${e}1`]:s,[`${e}2`]:o}=n,{value:a,interval:c}=SA(r,n);if(a==null||c==null&&!i)return n;let l=gs(r);if(c==null){let d,p={transform:_=>d||(d=Qe(_,a)),label:l};return{...n,[e]:void 0,[`${e}1`]:s===void 0?p:s,[`${e}2`]:o===void 0&&!(s===o&&i)?p:o}}let u,h;function f(d){return h!==void 0&&d===u?h:h=ye(Qe(u=d,a),p=>c.floor(p))}return t({...n,[e]:void 0,[`${e}1`]:s===void 0?{transform:f,label:l}:s,[`${e}2`]:o===void 0?{transform:d=>f(d).map(p=>c.offset(p)),label:l}:o})}function wA(e,t,n){let{[e]:i}=n,{value:r,interval:s}=SA(i,n);return r==null||s==null?n:t({...n,[e]:{label:gs(i),transform:o=>{let a=ye(Qe(o,r),l=>s.floor(l)),c=a.map(l=>s.offset(l));return a.map(je(a)?(l,u)=>l==null||isNaN(l=+l)||(u=c[u],u==null)||isNaN(u=+u)?void 0:new Date((l+u)/2):(l,u)=>l==null||(u=c[u],u==null)?NaN:(+l+ +u)/2)}}})}function TA(e={}){return py("x",hd,e,!0)}function dd(e={}){return py("x",hd,e)}function my(e={}){return py("y",dy,e)}function AA(e={}){return wA("x",hd,e)}function EA(e={}){return wA("y",dy,e)}var CA={ariaLabel:"rule",fill:null,stroke:"currentColor"},pd=class extends xe{constructor(t,n={}){let{x:i,y1:r,y2:s,inset:o=0,insetTop:a=o,insetBottom:c=o}=n;super(t,{x:{value:i,scale:"x",optional:!0},y1:{value:r,scale:"y",optional:!0},y2:{value:s,scale:"y",optional:!0}},Fa(n,"x"),CA),this.insetTop=Ie(a),this.insetBottom=Ie(c),Sl(this,n)}render(t,n,i,r,s){let{x:o,y:a}=n,{x:c,y1:l,y2:u}=i,{width:h,height:f,marginTop:d,marginRight:p,marginLeft:_,marginBottom:g}=r,{insetTop:m,insetBottom:x}=this;return ae("svg:g",s).call(Ve,this,r,s).call(He,this,{x:c&&o},cn,0).call(S=>S.selectAll().data(t).enter().append("line").call(Le,this).attr("x1",c?v=>c[v]:(_+h-p)/2).attr("x2",c?v=>c[v]:(_+h-p)/2).attr("y1",l&&!Ri(a)?v=>l[v]+m:d+m).attr("y2",u&&!Ri(a)?a.bandwidth?v=>u[v]+a.bandwidth()-x:v=>u[v]-x:f-g-x).call(ln,this,i).call(hy,this,i,s)).node()}},md=class extends xe{constructor(t,n={}){let{x1:i,x2:r,y:s,inset:o=0,insetRight:a=o,insetLeft:c=o}=n;super(t,{y:{value:s,scale:"y",optional:!0},x1:{value:i,scale:"x",optional:!0},x2:{value:r,scale:"x",optional:!0}},Fa(n,"y"),CA),this.insetRight=Ie(a),this.insetLeft=Ie(c),Sl(this,n)}render(t,n,i,r,s){let{x:o,y:a}=n,{y:c,x1:l,x2:u}=i,{width:h,height:f,marginTop:d,marginRight:p,marginLeft:_,marginBottom:g}=r,{insetLeft:m,insetRight:x}=this;return ae("svg:g",s).call(Ve,this,r,s).call(He,this,{y:c&&a},0,cn).call(S=>S.selectAll().data(t).enter().append("line").call(Le,this).attr("x1",l&&!Ri(o)?v=>l[v]+m:_+m).attr("x2",u&&!Ri(o)?o.bandwidth?v=>u[v]+o.bandwidth()-x:v=>u[v]-x:h-p-x).attr("y1",c?v=>c[v]:(d+f-g)/2).attr("y2",c?v=>c[v]:(d+f-g)/2).call(ln,this,i).call(hy,this,i,s)).node()}};function wl(e,t){let{x:n=be,y:i,y1:r,y2:s,...o}=my(t);return[r,s]=RA(i,r,s),new pd(e,{...o,x:n,y1:r,y2:s})}function Tl(e,t){let{y:n=be,x:i,x1:r,x2:s,...o}=dd(t);return[r,s]=RA(i,r,s),new md(e,{...o,y:n,x1:r,x2:s})}function RA(e,t,n){if(e==null){if(t===void 0){if(n!==void 0)return[0,n]}else if(n===void 0)return[0,t]}else{if(t===void 0)return n===void 0?[0,e]:[e,n];if(n===void 0)return[e,t]}return[t,n]}function Oa(e,...t){let n=t.length;for(let i=0,r=!0;i<n;++i)typeof t[i]!="function"&&(r&&(e=e.slice(),r=!1),e.splice(i,2,e[i]+t[i]+e[i+1]),t.splice(i,1),--i,--n);return i=>{let r=e[0];for(let s=0;s<n;++s)r+=t[s](i)+e[s+1];return r}}var L4={ariaLabel:"text",strokeLinejoin:"round",strokeWidth:3,paintOrder:"stroke"},DA="\xAD",Ba=class extends xe{constructor(t,n={}){let{x:i,y:r,text:s=pi(t)&&Zh(t)?be:ro,frameAnchor:o,textAnchor:a=/right$/i.test(o)?"end":/left$/i.test(o)?"start":"middle",lineAnchor:c=/^top/i.test(o)?"top":/^bottom/i.test(o)?"bottom":"middle",lineHeight:l=1,lineWidth:u=1/0,textOverflow:h,monospace:f,fontFamily:d=f?"ui-monospace, monospace":void 0,fontSize:p,fontStyle:_,fontVariant:g,fontWeight:m,rotate:x}=n,[S,v]=Ce(x,0),[w,b]=F4(p);if(super(t,{x:{value:i,scale:"x",optional:!0},y:{value:r,scale:"y",optional:!0},fontSize:{value:w,optional:!0},rotate:{value:Lw(S),optional:!0},text:{value:s,filter:dl,optional:!0}},n,L4),this.rotate=v,this.textAnchor=Re(a,"middle"),this.lineAnchor=Tn(c,"lineAnchor",["top","middle","bottom"]),this.lineHeight=+l,this.lineWidth=+u,this.textOverflow=_y(h),this.monospace=!!f,this.fontFamily=Pe(d),this.fontSize=b,this.fontStyle=Pe(_),this.fontVariant=Pe(g),this.fontWeight=Pe(m),this.frameAnchor=xs(o),!(this.lineWidth>=0))throw new Error(`invalid lineWidth: ${u}`);this.splitLines=by(this),this.clipLine=My(this)}render(t,n,i,r,s){let{x:o,y:a}=n,{x:c,y:l,rotate:u,text:h,title:f,fontSize:d}=i,{rotate:p}=this,[_,g]=sr(this,r);return ae("svg:g",s).call(Ve,this,r,s).call(vy,this,h,r).call(He,this,{x:c&&o,y:l&&a}).call(m=>m.selectAll().data(t).enter().append("text").call(Le,this).call(N4,this,h,f).attr("transform",Oa`translate(${c?x=>c[x]:_},${l?x=>l[x]:g})${u?x=>` rotate(${u[x]})`:p?` rotate(${p})`:""}`).call(Bt,"font-size",d&&(x=>d[x])).call(ln,this,i)).node()}};function _y(e){return e==null?null:Tn(e,"textOverflow",["clip","ellipsis","clip-start","clip-end","ellipsis-start","ellipsis-middle","ellipsis-end"]).replace(/^(clip|ellipsis)$/,"$1-end")}function N4(e,t,n,i){if(!n)return;let{lineAnchor:r,lineHeight:s,textOverflow:o,splitLines:a,clipLine:c}=t;e.each(function(l){let u=a(rr(n[l])??"").map(c),h=u.length,f=r==="top"?.71:r==="bottom"?1-h:(164-h*100)/200;if(h>1){let d=0;for(let p=0;p<h;++p){if(++d,!u[p])continue;let _=this.ownerDocument.createElementNS(rs.svg,"tspan");_.setAttribute("x",0),p===d-1?_.setAttribute("y",`${(f+p)*s}em`):_.setAttribute("dy",`${d*s}em`),_.textContent=u[p],this.appendChild(_),d=0}}else f&&this.setAttribute("y",`${f*s}em`),this.textContent=u[0];if(o&&!i&&u[0]!==n[l]){let d=this.ownerDocument.createElementNS(rs.svg,"title");d.textContent=n[l],this.appendChild(d)}})}function ka(e,{x:t,y:n,...i}={}){return i.frameAnchor===void 0&&([t,n]=Nr(t,n)),new Ba(e,{...i,x:t,y:n})}function yy(e,{x:t=be,...n}={}){return new Ba(e,EA({...n,x:t}))}function xy(e,{y:t=be,...n}={}){return new Ba(e,AA({...n,y:t}))}function vy(e,t,n){Bt(e,"text-anchor",t.textAnchor),Bt(e,"font-family",t.fontFamily),Bt(e,"font-size",t.fontSize),Bt(e,"font-style",t.fontStyle),Bt(e,"font-variant",t.fontVariant===void 0?D4(n):t.fontVariant),Bt(e,"font-weight",t.fontWeight)}function D4(e){return e&&(Uw(e)||je(e))?"tabular-nums":void 0}var U4=new Set(["inherit","initial","revert","unset","xx-small","x-small","small","medium","large","x-large","xx-large","xxx-large","larger","smaller"]);function F4(e){return e==null||typeof e=="number"?[void 0,e]:typeof e!="string"?[e,void 0]:(e=e.trim().toLowerCase(),U4.has(e)||/^[+-]?\d*\.?\d+(e[+-]?\d+)?(\w*|%)$/.test(e)?[void 0,e]:[e,void 0])}function O4(e,t,n){let i=[],r,s=0;for(let[o,a,c]of B4(e)){if(r===void 0&&(r=o),s>r&&n(e,r,a)>t&&(i.push(e.slice(r,s)+(e[s-1]===DA?"-":"")),r=o),c){i.push(e.slice(r,a)),r=void 0;continue}s=a}return i}function*B4(e){let t=0,n=0,i=e.length;for(;n<i;){let r=1;switch(e[n]){case DA:case"-":++n,yield[t,n,!1],t=n;break;case" ":for(yield[t,n,!1];e[++n]===" ";);t=n;break;case"\r":e[n+1]===`
`&&++r;case`
`:yield[t,n,!0],n+=r,t=n;break;default:++n;break}}yield[t,n,!0]}var PA={a:56,b:63,c:57,d:63,e:58,f:37,g:62,h:60,i:26,j:26,k:55,l:26,m:88,n:60,o:60,p:62,q:62,r:39,s:54,t:38,u:60,v:55,w:79,x:54,y:55,z:55,A:69,B:67,C:73,D:74,E:61,F:58,G:76,H:75,I:28,J:55,K:67,L:58,M:89,N:75,O:78,P:65,Q:78,R:67,S:65,T:65,U:75,V:69,W:98,X:69,Y:67,Z:67,0:64,1:48,2:62,3:64,4:66,5:63,6:65,7:58,8:65,9:65," ":29,"!":32,'"':49,"'":31,"(":39,")":39,",":31,"-":48,".":31,"/":32,":":31,";":31,"?":52,"\u2018":31,"\u2019":31,"\u201C":47,"\u201D":47,"\u2026":82};function gd(e,t=0,n=e.length){let i=0;for(let r=t;r<n;r=za(e,r))i+=PA[e[r]]??(FA(e,r)?120:PA.e);return i}function _d(e,t=0,n=e.length){let i=0;for(let r=t;r<n;r=za(e,r))i+=FA(e,r)?126:63;return i}function by({monospace:e,lineWidth:t,textOverflow:n}){if(n!=null||t==1/0)return s=>s.split(/\r\n?|\n/g);let i=e?_d:gd,r=t*100;return s=>O4(s,r,i)}function My({monospace:e,lineWidth:t,textOverflow:n}){if(n==null||t==1/0)return s=>s;let i=e?_d:gd,r=t*100;switch(n){case"clip-start":return s=>LA(s,r,i,"");case"clip-end":return s=>IA(s,r,i,"");case"ellipsis-start":return s=>LA(s,r,i,uo);case"ellipsis-middle":return s=>k4(s,r,i,uo);case"ellipsis-end":return s=>IA(s,r,i,uo)}}var uo="\u2026";function fo(e,t,n,i){let r=[],s=0;for(let o=0,a=0,c=e.length;o<c;o=a){a=za(e,o);let l=n(e,o,a);if(s+l>t){for(s+=i;s>t&&o>0;)a=o,o=r.pop(),s-=n(e,o,a);return[o,t-s]}s+=l,r.push(o)}return[-1,0]}function IA(e,t,n,i){e=e.trim();let r=n(i),[s]=fo(e,t,n,r);return s<0?e:e.slice(0,s).trimEnd()+i}function k4(e,t,n,i){e=e.trim();let r=n(e);if(r<=t)return e;let s=n(i)/2,[o,a]=fo(e,t/2,n,s),[c]=fo(e,r-t/2-a+s,n,-s);return c<0?i:e.slice(0,o).trimEnd()+i+e.slice(za(e,c)).trimStart()}function LA(e,t,n,i){e=e.trim();let r=n(e);if(r<=t)return e;let s=n(i),[o]=fo(e,r-t+s,n,-s);return o<0?i:i+e.slice(za(e,o)).trimStart()}var gy=/[\p{Combining_Mark}\p{Emoji_Modifier}]+/uy,NA=/\p{Extended_Pictographic}/uy;function za(e,t){return t+=z4(e,t)?2:1,V4(e,t)&&(t=gy.lastIndex),G4(e,t)?za(e,t+1):t}function UA(e,t){return e.charCodeAt(t)<128}function z4(e,t){let n=e.charCodeAt(t);if(n>=55296&&n<56320){let i=e.charCodeAt(t+1);return i>=56320&&i<57344}return!1}function G4(e,t){return e.charCodeAt(t)===8205}function V4(e,t){return UA(e,t)?!1:(gy.lastIndex=t,gy.test(e))}function FA(e,t){return UA(e,t)?!1:(NA.lastIndex=t,NA.test(e))}var H4={ariaLabel:"vector",fill:"none",stroke:"currentColor",strokeWidth:1.5,strokeLinejoin:"round",strokeLinecap:"round"},OA=3.5,W4=OA*5,BA={draw(e,t,n){let i=t*n/W4;e.moveTo(0,0),e.lineTo(0,-t),e.moveTo(-i,i-t),e.lineTo(0,-t),e.lineTo(i,i-t)}},$4={draw(e,t,n){e.moveTo(-n,0),e.lineTo(0,-t),e.lineTo(n,0)}},X4=new Map([["arrow",BA],["spike",$4]]);function q4(e){return e&&typeof e.draw=="function"}function Y4(e){if(q4(e))return e;let t=X4.get(`${e}`.toLowerCase());if(t)return t;throw new Error(`invalid shape: ${e}`)}var yd=class extends xe{constructor(t,n={}){let{x:i,y:r,r:s=OA,length:o,rotate:a,shape:c=BA,anchor:l="middle",frameAnchor:u}=n,[h,f]=Ce(o,12),[d,p]=Ce(a,0);super(t,{x:{value:i,scale:"x",optional:!0},y:{value:r,scale:"y",optional:!0},length:{value:h,scale:"length",optional:!0},rotate:{value:d,optional:!0}},n,H4),this.r=+s,this.length=f,this.rotate=p,this.shape=Y4(c),this.anchor=Tn(l,"anchor",["start","middle","end"]),this.frameAnchor=xs(u)}render(t,n,i,r,s){let{x:o,y:a}=n,{x:c,y:l,length:u,rotate:h}=i,{length:f,rotate:d,anchor:p,shape:_,r:g}=this,[m,x]=sr(this,r);return ae("svg:g",s).call(Ve,this,r,s).call(He,this,{x:c&&o,y:l&&a}).call(S=>S.selectAll().data(t).enter().append("path").call(Le,this).attr("transform",Oa`translate(${c?v=>c[v]:m},${l?v=>l[v]:x})${h?v=>` rotate(${h[v]})`:d?` rotate(${d})`:""}${p==="start"?"":p==="end"?u?v=>` translate(0,${u[v]})`:` translate(0,${f})`:u?v=>` translate(0,${u[v]/2})`:` translate(0,${f/2})`}`).attr("d",u?v=>{let w=Hi();return _.draw(w,u[v],g),w}:(()=>{let v=Hi();return _.draw(v,f,g),v})()).call(ln,this,i)).node()}};function kA(e,t={}){let{x:n=be,...i}=t;return new yd(e,{...i,x:n})}function zA(e,t={}){let{y:n=be,...i}=t;return new yd(e,{...i,y:n})}function bs(e,t){return arguments.length<2&&!pi(e)&&(t=e,e=null),t===void 0&&(t={}),[e,t]}function xd({anchor:e}={},t){return e===void 0?t[0]:Tn(e,"anchor",t)}function GA(e){return xd(e,["left","right"])}function VA(e){return xd(e,["right","left"])}function HA(e){return xd(e,["bottom","top"])}function WA(e){return xd(e,["top","bottom"])}function wy(){let[e,t]=bs(...arguments);return qA("y",GA(t),e,t)}function $A(){let[e,t]=bs(...arguments);return qA("fy",VA(t),e,t)}function Ty(){let[e,t]=bs(...arguments);return YA("x",HA(t),e,t)}function XA(){let[e,t]=bs(...arguments);return YA("fx",WA(t),e,t)}function qA(e,t,n,{color:i="currentColor",opacity:r=1,stroke:s=i,strokeOpacity:o=r,strokeWidth:a=1,fill:c=i,fillOpacity:l=r,textAnchor:u,textStroke:h,textStrokeOpacity:f,textStrokeWidth:d,tickSize:p=e==="y"?6:0,tickPadding:_,tickRotate:g,x:m,margin:x,marginTop:S=x===void 0?20:x,marginRight:v=x===void 0?t==="right"?40:0:x,marginBottom:w=x===void 0?20:x,marginLeft:b=x===void 0?t==="left"?40:0:x,label:y,labelAnchor:M,labelArrow:R,labelOffset:C,ariaLabel:E=`${e}-axis`,...N}){return p=Ie(p),_=Ie(_),g=Ie(g),M!==void 0&&(M=Tn(M,"labelAnchor",["center","top","bottom"])),R=oE(R),ny(p&&!tn(s)?Z4(e,t,n,{stroke:s,strokeOpacity:o,strokeWidth:a,tickSize:p,tickPadding:_,tickRotate:g,x:m,ariaLabel:E,...N}):null,tn(c)?null:K4(e,t,n,{fill:c,fillOpacity:l,stroke:h,strokeOpacity:f,strokeWidth:d,textAnchor:u,tickSize:p,tickPadding:_,tickRotate:g,x:m,marginTop:S,marginRight:v,marginBottom:w,marginLeft:b,ariaLabel:E,...N}),!tn(c)&&y!==null?ka([],nE({fill:c,fillOpacity:l,...N},function(k,P,L,B,U){let Z=B[e],{marginTop:F,marginRight:G,marginBottom:q,marginLeft:rt}=e==="y"&&U.inset||U,ct=M??(Z.bandwidth?"center":"top"),$=C??(t==="right"?G:rt)-3;return ct==="center"?(this.textAnchor=void 0,this.lineAnchor=t==="right"?"bottom":"top",this.frameAnchor=t,this.rotate=-90):(this.textAnchor=t==="right"?"end":"start",this.lineAnchor=ct,this.frameAnchor=`${ct}-${t}`,this.rotate=0),this.dy=ct==="top"?3-F:ct==="bottom"?q-3:0,this.dx=t==="right"?$:-$,this.ariaLabel=`${E} label`,{facets:[[0]],channels:{text:{value:[sE(e,Z,{anchor:t,label:y,labelAnchor:ct,labelArrow:R})]}}}})):null)}function YA(e,t,n,{color:i="currentColor",opacity:r=1,stroke:s=i,strokeOpacity:o=r,strokeWidth:a=1,fill:c=i,fillOpacity:l=r,textAnchor:u,textStroke:h,textStrokeOpacity:f,textStrokeWidth:d,tickSize:p=e==="x"?6:0,tickPadding:_,tickRotate:g,y:m,margin:x,marginTop:S=x===void 0?t==="top"?30:0:x,marginRight:v=x===void 0?20:x,marginBottom:w=x===void 0?t==="bottom"?30:0:x,marginLeft:b=x===void 0?20:x,label:y,labelAnchor:M,labelArrow:R,labelOffset:C,ariaLabel:E=`${e}-axis`,...N}){return p=Ie(p),_=Ie(_),g=Ie(g),M!==void 0&&(M=Tn(M,"labelAnchor",["center","left","right"])),R=oE(R),ny(p&&!tn(s)?J4(e,t,n,{stroke:s,strokeOpacity:o,strokeWidth:a,tickSize:p,tickPadding:_,tickRotate:g,y:m,ariaLabel:E,...N}):null,tn(c)?null:j4(e,t,n,{fill:c,fillOpacity:l,stroke:h,strokeOpacity:f,strokeWidth:d,textAnchor:u,tickSize:p,tickPadding:_,tickRotate:g,y:m,marginTop:S,marginRight:v,marginBottom:w,marginLeft:b,ariaLabel:E,...N}),!tn(c)&&y!==null?ka([],nE({fill:c,fillOpacity:l,...N},function(k,P,L,B,U){let Z=B[e],{marginTop:F,marginRight:G,marginBottom:q,marginLeft:rt}=e==="x"&&U.inset||U,ct=M??(Z.bandwidth?"center":"right"),$=C??(t==="top"?F:q)-3;return ct==="center"?(this.frameAnchor=t,this.textAnchor=void 0):(this.frameAnchor=`${t}-${ct}`,this.textAnchor=ct==="right"?"end":"start"),this.lineAnchor=t,this.dy=t==="top"?-$:$,this.dx=ct==="right"?G-3:ct==="left"?3-rt:0,this.ariaLabel=`${E} label`,{facets:[[0]],channels:{text:{value:[sE(e,Z,{anchor:t,label:y,labelAnchor:ct,labelArrow:R})]}}}})):null)}function Z4(e,t,n,{strokeWidth:i=1,strokeLinecap:r=null,strokeLinejoin:s=null,facetAnchor:o=t+(e==="y"?"-empty":""),frameAnchor:a=t,tickSize:c,inset:l=0,insetLeft:u=l,insetRight:h=l,dx:f=0,y:d=e==="y"?void 0:null,ariaLabel:p,..._}){return Ga(zA,e,n,{ariaLabel:`${p} tick`,ariaHidden:!0},{strokeWidth:i,strokeLinecap:r,strokeLinejoin:s,facetAnchor:o,frameAnchor:a,y:d,..._,dx:t==="left"?+f-cn+ +u:+f+cn-h,anchor:"start",length:c,shape:t==="left"?n5:i5})}function J4(e,t,n,{strokeWidth:i=1,strokeLinecap:r=null,strokeLinejoin:s=null,facetAnchor:o=t+(e==="x"?"-empty":""),frameAnchor:a=t,tickSize:c,inset:l=0,insetTop:u=l,insetBottom:h=l,dy:f=0,x:d=e==="x"?void 0:null,ariaLabel:p,..._}){return Ga(kA,e,n,{ariaLabel:`${p} tick`,ariaHidden:!0},{strokeWidth:i,strokeLinejoin:s,strokeLinecap:r,facetAnchor:o,frameAnchor:a,x:d,..._,dy:t==="bottom"?+f-cn-h:+f+cn+ +u,anchor:"start",length:c,shape:t==="bottom"?t5:e5})}function K4(e,t,n,{facetAnchor:i=t+(e==="y"?"-empty":""),frameAnchor:r=t,tickSize:s,tickRotate:o=0,tickPadding:a=Math.max(3,9-s)+(Math.abs(o)>60?4*Math.cos(o*cy):0),text:c,textAnchor:l=Math.abs(o)>60?"middle":t==="left"?"end":"start",lineAnchor:u=o>60?"top":o<-60?"bottom":"middle",fontVariant:h,inset:f=0,insetLeft:d=f,insetRight:p=f,dx:_=0,ariaLabel:g,y:m=e==="y"?void 0:null,...x}){return Ga(xy,e,n,{ariaLabel:`${g} tick label`},{facetAnchor:i,frameAnchor:r,text:c,textAnchor:l,lineAnchor:u,fontVariant:h,rotate:o,y:m,...x,dx:t==="left"?+_-s-a+ +d:+_+ +s+ +a-p},function(S,v,w,b,y){h===void 0&&(this.fontVariant=rE(S)),c===void 0&&(y.text=iE(S,v,w,b,t))})}function j4(e,t,n,{facetAnchor:i=t+(e==="x"?"-empty":""),frameAnchor:r=t,tickSize:s,tickRotate:o=0,tickPadding:a=Math.max(3,9-s)+(Math.abs(o)>=10?4*Math.cos(o*cy):0),text:c,textAnchor:l=Math.abs(o)>=10?o<0^t==="bottom"?"start":"end":"middle",lineAnchor:u=Math.abs(o)>=10?"middle":t==="bottom"?"top":"bottom",fontVariant:h,inset:f=0,insetTop:d=f,insetBottom:p=f,dy:_=0,x:g=e==="x"?void 0:null,ariaLabel:m,...x}){return Ga(yy,e,n,{ariaLabel:`${m} tick label`},{facetAnchor:i,frameAnchor:r,text:c===void 0?null:c,textAnchor:l,lineAnchor:u,fontVariant:h,rotate:o,x:g,...x,dy:t==="bottom"?+_+ +s+ +a-p:+_-s-a+ +d},function(S,v,w,b,y){h===void 0&&(this.fontVariant=rE(S)),c===void 0&&(y.text=iE(S,v,w,b,t))})}function ZA(){let[e,t]=bs(...arguments);return QA("y",GA(t),e,t)}function JA(){let[e,t]=bs(...arguments);return QA("fy",VA(t),e,t)}function KA(){let[e,t]=bs(...arguments);return tE("x",HA(t),e,t)}function jA(){let[e,t]=bs(...arguments);return tE("fx",WA(t),e,t)}function QA(e,t,n,{y:i=e==="y"?void 0:null,x:r=null,x1:s=t==="left"?r:null,x2:o=t==="right"?r:null,ariaLabel:a=`${e}-grid`,ariaHidden:c=!0,...l}){return Ga(Tl,e,n,{ariaLabel:a,ariaHidden:c},{y:i,x1:s,x2:o,...eE(l)})}function tE(e,t,n,{x:i=e==="x"?void 0:null,y:r=null,y1:s=t==="top"?r:null,y2:o=t==="bottom"?r:null,ariaLabel:a=`${e}-grid`,ariaHidden:c=!0,...l}){return Ga(wl,e,n,{ariaLabel:a,ariaHidden:c},{x:i,y1:s,y2:o,...eE(l)})}function eE({color:e="currentColor",opacity:t=.1,stroke:n=e,strokeOpacity:i=t,strokeWidth:r=1,...s}){return{stroke:n,strokeOpacity:i,strokeWidth:r,...s}}function nE({fill:e,fillOpacity:t,fontFamily:n,fontSize:i,fontStyle:r,fontVariant:s,fontWeight:o,monospace:a,pointerEvents:c,shapeRendering:l,clip:u=!1},h){return[,e]=tr(e),[,t]=Ce(t),{facet:"super",x:null,y:null,fill:e,fillOpacity:t,fontFamily:n,fontSize:i,fontStyle:r,fontVariant:s,fontWeight:o,monospace:a,pointerEvents:c,shapeRendering:l,clip:u,initializer:h}}function Ga(e,t,n,i,r,s){let o;function a(u,h,f,d,p,_){let g=u==null&&(t==="fx"||t==="fy"),{[t]:m}=d;if(!m)throw new Error(`missing scale: ${t}`);let x=m.domain(),{interval:S,ticks:v,tickFormat:w,tickSpacing:b=t==="x"?80:35}=r;if(typeof v=="string"&&aE(m)&&(S=v,v=void 0),v===void 0&&(v=_s(S,m.type)??Q4(m,b)),u==null){if(pi(v))u=er(v);else if(Iw(v))u=Sy(v,...ni(x));else if(m.interval){let M=m.interval;if(m.ticks){let[R,C]=ni(x),E=(C-R)/M[va];M=h_(M,E/v)??M,u=Sy(M,R,C)}else{u=x;let R=u.length;M=h_(M,R/v)??M,M!==m.interval&&(u=Sy(M,...ni(u)))}if(M===m.interval){let R=Math.round(u.length/v);R>1&&(u=u.filter((C,E)=>E%R===0))}}else m.ticks?u=m.ticks(v):u=x;if(!m.ticks&&u.length&&u!==x){let M=new ki(x);u=u.filter(R=>M.has(R)),u.length||Dn(`Warning: the ${t}-axis ticks appear to not align with the scale domain, resulting in no ticks. Try different ticks?`)}t==="y"||t==="x"?h=[Nn(u)]:o[t]={scale:t,value:be}}s?.call(this,m,u,v,w,o);let y=Object.fromEntries(Object.entries(o).map(([M,R])=>[M,{...R,value:Qe(u,R.value)}]));return g&&(h=_.filterFacets(u,y)),{data:u,facets:h,channels:y}}let c=Dr(r).initializer,l=e(n,Dr({...r,initializer:a},c));return n==null?(o=l.channels,l.channels={}):o={},i!==void 0&&Object.assign(l,i),l.clip===void 0&&(l.clip=!1),l}function Q4(e,t){let[n,i]=ni(e.range());return(i-n)/t}function iE(e,t,n,i,r){return{value:Al(e,t,n,i,r)}}function Al(e,t,n,i,r){return typeof i=="function"&&!(e.type==="log"&&e.tickFormat)?i:i===void 0&&t&&je(t)?_w(e.type,t,r)??rr:e.tickFormat?e.tickFormat(typeof n=="number"?n:null,i):typeof i=="string"&&e.domain().length>0?(je(e.domain())?Ji:Wi)(i):i===void 0?rr:Vn(i)}function Sy(e,t,n){return e.range(t,e.offset(e.floor(n)))}var t5={draw(e,t){e.moveTo(0,0),e.lineTo(0,t)}},e5={draw(e,t){e.moveTo(0,0),e.lineTo(0,-t)}},n5={draw(e,t){e.moveTo(0,0),e.lineTo(-t,0)}},i5={draw(e,t){e.moveTo(0,0),e.lineTo(t,0)}};function rE(e){return e.bandwidth&&!e.interval?void 0:"tabular-nums"}function sE(e,t,{anchor:n,label:i=t.label,labelAnchor:r,labelArrow:s}={}){if(!(i==null||i.inferred&&aE(t)&&/^(date|time|year)$/i.test(i))){if(i=String(i),s==="auto"&&(s=(!t.bandwidth||t.interval)&&!/[↑↓→←]/.test(i)),!s)return i;if(s===!0){let o=HT(t);o&&(s=/x$/.test(e)||r==="center"?/x$/.test(e)===o<0?"left":"right":o<0?"up":"down")}switch(s){case"left":return`\u2190 ${i}`;case"right":return`${i} \u2192`;case"up":return n==="right"?`${i} \u2191`:`\u2191 ${i}`;case"down":return n==="right"?`${i} \u2193`:`\u2193 ${i}`}return i}}function oE(e="auto"){return tn(e)?!1:typeof e=="boolean"?e:Tn(e,"labelArrow",["auto","up","right","down","left"])}function aE(e){return je(e.domain())}function cE(e,t){if(t==null)return t;let n=e(t);if(!n)throw new Error(`scale not found: ${t}`);return n}function lE(e,{opacity:t,...n}={}){if(!ir(e)&&!Y_(e))throw new Error(`swatches legend requires ordinal or threshold color scale (not ${e.type})`);return fE(e,n,(i,r,s,o)=>i.append("svg").attr("width",s).attr("height",o).attr("fill",r.scale).attr("fill-opacity",Ce(t)[1]).append("rect").attr("width","100%").attr("height","100%"))}function uE(e,{fill:t=e.hint?.fill!==void 0?e.hint.fill:"none",fillOpacity:n=1,stroke:i=e.hint?.stroke!==void 0?e.hint.stroke:tn(t)?"currentColor":"none",strokeOpacity:r=1,strokeWidth:s=1.5,r:o=4.5,...a}={},c){let[l,u]=tr(t),[h,f]=tr(i),d=cE(c,l),p=cE(c,h),_=o*o*Math.PI;return n=Ce(n)[1],r=Ce(r)[1],s=Ce(s)[1],fE(e,a,(g,m,x,S)=>g.append("svg").attr("viewBox","-8 -8 16 16").attr("width",x).attr("height",S).attr("fill",l==="color"?v=>d.scale(v):u).attr("fill-opacity",n).attr("stroke",h==="color"?v=>p.scale(v):f).attr("stroke-opacity",r).attr("stroke-width",s).append("path").attr("d",v=>{let w=Hi();return e.scale(v).draw(w,_),w}))}function fE(e,t={},n){let{columns:i,tickFormat:r,fontVariant:s=fd(e),swatchSize:o=15,swatchWidth:a=o,swatchHeight:c=o,marginLeft:l=0,className:u,style:h,width:f}=t,d=Na(t);u=Da(u),r=Al(e.scale,e.domain,void 0,r);let p=ae("div",d).attr("class",`${u}-swatches ${u}-swatches-${i!=null?"columns":"wrap"}`),_;return i!=null?(_=`:where(.${u}-swatches-columns .${u}-swatch) {
  display: flex;
  align-items: center;
  break-inside: avoid;
  padding-bottom: 1px;
}
:where(.${u}-swatches-columns .${u}-swatch::before) {
  flex-shrink: 0;
}
:where(.${u}-swatches-columns .${u}-swatch-label) {
  white-space: nowrap;
  overflow: hidden;
  text-overflow: ellipsis;
}`,p.style("columns",i).selectAll().data(e.domain).enter().append("div").attr("class",`${u}-swatch`).call(n,e,a,c).call(g=>g.append("div").attr("class",`${u}-swatch-label`).attr("title",r).text(r))):(_=`:where(.${u}-swatches-wrap) {
  display: flex;
  align-items: center;
  min-height: 33px;
  flex-wrap: wrap;
}
:where(.${u}-swatches-wrap .${u}-swatch) {
  display: inline-flex;
  align-items: center;
  margin-right: 1em;
}`,p.selectAll().data(e.domain).enter().append("span").attr("class",`${u}-swatch`).call(n,e,a,c).append(function(){return this.ownerDocument.createTextNode(r.apply(this,arguments))})),p.call(g=>g.insert("style","*").text(`:where(.${u}-swatches) {
  font-family: system-ui, sans-serif;
  font-size: 10px;
  margin-bottom: 0.5em;
}
:where(.${u}-swatch > svg) {
  margin-right: 0.5em;
  overflow: visible;
}
${_}`)).style("margin-left",l?`${+l}px`:null).style("width",f===void 0?null:`${+f}px`).style("font-variant",Re(s,"normal")).call(Ua,h).node()}var Ay=new Map([["symbol",uE],["color",pE],["opacity",r5]]);function hE(e,t,n={}){return(i,r)=>{if(!Ay.has(i))throw new Error(`unknown legend type: ${i}`);if(i in e)return Ay.get(i)(e[i],dE(t,n[i],r),s=>e[s])}}function dE({className:e,...t},{label:n,ticks:i,tickFormat:r}={},s){return Bw(s,{className:e,...t},{label:n,ticks:i,tickFormat:r})}function pE(e,{legend:t=!0,...n}){if(t===!0&&(t=e.type==="ordinal"?"swatches":"ramp"),e.domain!==void 0)switch(`${t}`.toLowerCase()){case"swatches":return lE(e,n);case"ramp":return gA(e,n);default:throw new Error(`unknown legend type: ${t}`)}}function r5({type:e,interpolate:t,...n},{legend:i=!0,color:r=Ei(0,0,0),...s}){if(!t)throw new Error(`${e} opacity scales are not supported`);if(i===!0&&(i="ramp"),`${i}`.toLowerCase()!=="ramp")throw new Error(`${i} opacity legends are not supported`);return pE({type:e,...n,interpolate:s5(r)},{legend:i,...s})}function s5(e){let{r:t,g:n,b:i}=Ei(e)||Ei(0,0,0);return r=>`rgba(${t},${n},${i},${r})`}function mE(e,t,n){let i=[];for(let[r,s]of Ay){let o=n[r];if(o?.legend&&r in e){let a=s(e[r],dE(t,e[r],o),c=>e[c]);a!=null&&i.push(a)}}return i}function Ey(e={},t="x"){return M_(e)?e:{...e,[t]:be}}function Cy(e={},t="y"){return S_(e)?e:{...e,[t]:be}}function gE(e,t){if(t.length===1)return{data:e,facets:t};let n=ms(e),i=new Uint8Array(n),r=0;for(let a of t)for(let c of a)i[c]&&++r,i[c]=1;if(r===0)return{data:e,facets:t};e=ds(e);let s=e[m_]=new Uint32Array(n+r);t=t.map(a=>ds(a,Uint32Array));let o=n;i.fill(0);for(let a of t)for(let c=0,l=a.length;c<l;++c){let u=a[c];i[u]?(a[c]=o,e[o]=e[u],s[o]=u,++o):s[u]=u,i[u]=1}return{data:e,facets:t}}function o5(e={},t={}){arguments.length===1&&([e,t]=xE(e));let{y1:n,y:i=n,x:r,...s}=t,[o,a,c,l]=vE(i,r,"y","x",e,s);return{...o,y1:n,y:a,x1:c,x2:l,x:T_(c,l)}}function a5(e={},t={}){arguments.length===1&&([e,t]=xE(e));let{x1:n,x:i=n,y:r,...s}=t,[o,a,c,l]=vE(i,r,"x","y",e,s);return{...o,x1:n,x:a,y1:c,y2:l,y:T_(c,l)}}function Ry({x:e,x1:t,x2:n,...i}={}){return i=Fa(i,"y"),t===void 0&&n===void 0?o5({x:e,...i}):([t,n]=w_(e,t,n),{...i,x1:t,x2:n})}function Py({y:e,y1:t,y2:n,...i}={}){return i=Fa(i,"x"),t===void 0&&n===void 0?a5({y:e,...i}):([t,n]=w_(e,t,n),{...i,y1:t,y2:n})}function xE(e){let{offset:t,order:n,reverse:i,...r}=e;return[{offset:t,order:n,reverse:i},r]}var c5={length:!0};function vE(e,t=Mw,n,i,{offset:r,order:s,reverse:o},a){if(t===null)throw new Error(`stack requires ${i}`);let c=Xh(a),[l,u]=Cw(e),[h,f]=gl(t),[d,p]=gl(t);return h.hint=d.hint=c5,r=l5(r),s=h5(s,r,i),[_l(a,(_,g,m)=>{({data:_,facets:g}=gE(_,g));let x=e==null?void 0:u(Rw(Qe(_,e),m?.[n])),S=Qe(_,t,Float64Array),v=Qe(_,c),w=s&&s(_,x,S,v),b=ms(_),y=f(new Float64Array(b)),M=p(new Float64Array(b)),R=[];for(let C of g){let E=x?Array.from(Zo(C,N=>x[N]).values()):[C];if(w)for(let N of E)N.sort(w);for(let N of E){let k=0,P=0;o&&N.reverse();for(let L of N){let B=S[L];B<0?k=M[L]=(y[L]=k)+B:B>0?P=M[L]=(y[L]=P)+B:M[L]=y[L]=P}}R.push(E)}return r&&r(R,y,M,v),{data:_,facets:g}}),l,h,d]}function l5(e){if(e!=null){if(typeof e=="function")return e;switch(`${e}`.toLowerCase()){case"expand":case"normalize":return u5;case"center":case"silhouette":return f5;case"wiggle":return ME}throw new Error(`unknown offset: ${e}`)}}function bE(e,t){let n=0,i=0;for(let r of e){let s=t[r];s<n&&(n=s),s>i&&(i=s)}return[n,i]}function u5(e,t,n){for(let i of e)for(let r of i){let[s,o]=bE(r,n);for(let a of r){let c=1/(o-s||1);t[a]=c*(t[a]-s),n[a]=c*(n[a]-s)}}}function f5(e,t,n){for(let i of e){for(let r of i){let[s,o]=bE(r,n);for(let a of r){let c=(o+s)/2;t[a]-=c,n[a]-=c}}SE(i,t,n)}wE(e,t,n)}function ME(e,t,n,i){for(let r of e){let s=new ti,o=0;for(let a of r){let c=-1,l=a.map(d=>Math.abs(n[d]-t[d])),u=a.map(d=>{c=i?i[d]:++c;let p=n[d]-t[d],_=s.has(c)?p-s.get(c):0;return s.set(c,p),_}),h=[0,...ib(u)];for(let d of a)t[d]+=o,n[d]+=o;let f=zi(l);f&&(o-=zi(l,(d,p)=>(u[p]/2+h[p])*d)/f)}SE(r,t,n)}wE(e,t,n)}function SE(e,t,n){let i=ei(e,r=>ei(r,s=>t[s]));for(let r of e)for(let s of r)t[s]-=i,n[s]-=i}function wE(e,t,n){let i=e.length;if(i===1)return;let r=e.map(a=>a.flat()),s=r.map(a=>(ei(a,c=>t[c])+bn(a,c=>n[c]))/2),o=ei(s);for(let a=0;a<i;a++){let c=o-s[a];for(let l of r[a])t[l]+=c,n[l]+=c}}function h5(e,t,n){if(e===void 0&&t===ME)return _E(Ln);if(e!=null){if(typeof e=="string"){let i=e.startsWith("-"),r=i?eo:Ln;switch((i?e.slice(1):e).toLowerCase()){case"value":case n:return d5(r);case"z":return p5(r);case"sum":return m5(r);case"appearance":return g5(r);case"inside-out":return _E(r)}return yE(__(e))}if(typeof e=="function")return(e.length===1?yE:_5)(e);if(Ci(e))return y5(e);throw new Error(`invalid order: ${e}`)}}function d5(e){return(t,n,i)=>(r,s)=>e(i[r],i[s])}function p5(e){return(t,n,i,r)=>(s,o)=>e(r[s],r[o])}function m5(e){return vd(e,(t,n,i,r)=>kf(Nn(t),s=>zi(s,o=>i[o]),s=>r[s]))}function g5(e){return vd(e,(t,n,i,r)=>kf(Nn(t),s=>n[fm(s,o=>i[o])],s=>r[s]))}function _E(e){return vd(e,(t,n,i,r)=>{let s=Nn(t),o=kf(s,h=>n[fm(h,f=>i[f])],h=>r[h]),a=is(s,h=>zi(h,f=>i[f]),h=>r[h]),c=[],l=[],u=0;for(let h of o)u<0?(u+=a.get(h),c.push(h)):(u-=a.get(h),l.push(h));return l.reverse().concat(c)})}function yE(e){return t=>{let n=Qe(t,e);return(i,r)=>Ln(n[i],n[r])}}function _5(e){return t=>Ci(t)?(n,i)=>e(t[n],t[i]):(n,i)=>e(t.get(n),t.get(i))}function y5(e){return vd(Ln,()=>e)}function vd(e,t){return(n,i,r,s)=>{if(!s)throw new Error("missing channel: z");let o=new ti(t(n,i,r,s).map((a,c)=>[a,c]));return(a,c)=>e(o.get(s[a]),o.get(s[c]))}}var x5={ariaLabel:"rect"},Sd=class extends xe{constructor(t,n={}){let{x1:i,y1:r,x2:s,y2:o}=n;super(t,{x1:{value:i,scale:"x",type:i!=null&&s==null?"band":void 0,optional:!0},y1:{value:r,scale:"y",type:r!=null&&o==null?"band":void 0,optional:!0},x2:{value:s,scale:"x",optional:!0},y2:{value:o,scale:"y",optional:!0}},n,x5),El(this,n),Cl(this,n)}render(t,n,i,r,s){let{x:o,y:a}=n,{x1:c,y1:l,x2:u,y2:h}=i,{marginTop:f,marginRight:d,marginBottom:p,marginLeft:_,width:g,height:m}=r,{projection:x}=s,{insetTop:S,insetRight:v,insetBottom:w,insetLeft:b}=this,{rx:y,ry:M,rx1y1:R,rx1y2:C,rx2y1:E,rx2y2:N}=this;(c||u)&&!x&&Ri(o)&&(c=u=null),(l||h)&&!x&&Ri(a)&&(l=h=null);let k=o?.bandwidth?o.bandwidth():0,P=a?.bandwidth?a.bandwidth():0;return ae("svg:g",s).call(Ve,this,r,s).call(He,this,{},0,0).call(L=>L.selectAll().data(t).enter().call(R||C||E||N?B=>B.append("path").call(Le,this).call(Rl,c&&u?U=>c[U]+(u[U]<c[U]?-v:b):c?U=>c[U]+b:_+b,l&&h?U=>l[U]+(h[U]<l[U]?-w:S):l?U=>l[U]+S:f+S,c&&u?U=>u[U]-(u[U]<c[U]?-b:v):c?U=>c[U]+k-v:g-d-v,l&&h?U=>h[U]-(h[U]<l[U]?-S:w):l?U=>l[U]+P-w:m-p-w,this).call(ln,this,i):B=>B.append("rect").call(Le,this).attr("x",c?u?U=>Math.min(c[U],u[U])+b:U=>c[U]+b:_+b).attr("y",l?h?U=>Math.min(l[U],h[U])+S:U=>l[U]+S:f+S).attr("width",c?u?U=>Math.max(0,Math.abs(u[U]-c[U])+k-b-v):k-b-v:g-d-_-v-b).attr("height",l?h?U=>Math.max(0,Math.abs(l[U]-h[U])+P-S-w):P-S-w:m-f-p-S-w).call(Bt,"rx",y).call(Bt,"ry",M).call(ln,this,i))).node()}};function El(e,{inset:t=0,insetTop:n=t,insetRight:i=t,insetBottom:r=t,insetLeft:s=t}={}){e.insetTop=Ie(n),e.insetRight=Ie(i),e.insetBottom=Ie(r),e.insetLeft=Ie(s)}function Cl(e,{r:t,rx:n,ry:i,rx1:r=t,ry1:s=t,rx2:o=t,ry2:a=t,rx1y1:c=r!==void 0?+r:s!==void 0?+s:0,rx1y2:l=r!==void 0?+r:a!==void 0?+a:0,rx2y1:u=o!==void 0?+o:s!==void 0?+s:0,rx2y2:h=o!==void 0?+o:a!==void 0?+a:0}={}){c||l||u||h?(e.rx1y1=c,e.rx1y2=l,e.rx2y1=u,e.rx2y2=h):(e.rx=Re(n,"auto"),e.ry=Re(i,"auto"))}function Rl(e,t,n,i,r,s){let{rx1y1:o,rx1y2:a,rx2y1:c,rx2y2:l}=s;typeof t!="function"&&(t=Vn(t)),typeof n!="function"&&(n=Vn(n)),typeof i!="function"&&(i=Vn(i)),typeof r!="function"&&(r=Vn(r));let u=Math.max(Math.abs(o+c),Math.abs(a+l)),h=Math.max(Math.abs(o+a),Math.abs(c+l));e.attr("d",f=>{let d=t(f),p=n(f),_=i(f),g=r(f),m=d>_,x=p>g,S=m?_:d,v=m?d:_,w=x?g:p,b=x?p:g,y=Math.min(1,(v-S)/u,(b-w)/h),M=y*(m?x?l:c:x?a:o),R=y*(m?x?a:o:x?l:c),C=y*(m?x?o:a:x?c:l),E=y*(m?x?c:l:x?o:a);return`M${S},${w+Md(M,E)}A${M},${M} 0 0 ${M<0?0:1} ${S+bd(M,E)},${w}H${v-bd(R,C)}A${R},${R} 0 0 ${R<0?0:1} ${v},${w+Md(R,C)}V${b-Md(C,R)}A${C},${C} 0 0 ${C<0?0:1} ${v-bd(C,R)},${b}H${S+bd(E,M)}A${E},${E} 0 0 ${E<0?0:1} ${S},${b-Md(E,M)}Z`})}function bd(e,t){return t<0?e:Math.abs(e)}function Md(e,t){return t<0?Math.abs(e):e}function Iy(e,t={}){return $h(t)||(t={...t,x:ro,y2:be,interval:1}),new Sd(e,Py(TA(Cy(t))))}var v5={ariaLabel:"frame",fill:"none",stroke:"currentColor",clip:!1},b5={ariaLabel:"frame",fill:null,stroke:"currentColor",strokeLinecap:"square",clip:!1},Ly=class extends xe{constructor(t={}){let{anchor:n=null}=t;super(ba,void 0,t,n==null?v5:b5),this.anchor=b_(n,"anchor",["top","right","bottom","left"]),El(this,t),n||Cl(this,t)}render(t,n,i,r,s){let{marginTop:o,marginRight:a,marginBottom:c,marginLeft:l,width:u,height:h}=r,{anchor:f,insetTop:d,insetRight:p,insetBottom:_,insetLeft:g}=this,{rx:m,ry:x,rx1y1:S,rx1y2:v,rx2y1:w,rx2y2:b}=this,y=l+g,M=u-a-p,R=o+d,C=h-c-_;return ae(f?"svg:line":S||v||w||b?"svg:path":"svg:rect",s).datum(0).call(Ve,this,r,s).call(Le,this).call(ln,this,i).call(He,this,{}).call(f==="left"?E=>E.attr("x1",y).attr("x2",y).attr("y1",R).attr("y2",C):f==="right"?E=>E.attr("x1",M).attr("x2",M).attr("y1",R).attr("y2",C):f==="top"?E=>E.attr("x1",y).attr("x2",M).attr("y1",R).attr("y2",R):f==="bottom"?E=>E.attr("x1",y).attr("x2",M).attr("y1",C).attr("y2",C):S||v||w||b?E=>E.call(Rl,y,R,M,C,this):E=>E.attr("x",y).attr("y",R).attr("width",M-y).attr("height",C-R).attr("rx",m).attr("ry",x)).node()}};function TE(e){return new Ly(e)}var Ny={ariaLabel:"tip",fill:"var(--plot-background)",stroke:"currentColor"},M5=new Set(["geometry","href","src","ariaLabel","scales"]),wd=class extends xe{constructor(t,n={}){n.tip&&(n={...n,tip:!1}),n.title===void 0&&pi(t)&&Zh(t)&&(n={...n,title:be});let{x:i,y:r,x1:s,x2:o,y1:a,y2:c,anchor:l,preferredAnchor:u="bottom",monospace:h,fontFamily:f=h?"ui-monospace, monospace":void 0,fontSize:d,fontStyle:p,fontVariant:_,fontWeight:g,lineHeight:m=1,lineWidth:x=20,frameAnchor:S,format:v,textAnchor:w="start",textOverflow:b,textPadding:y=8,title:M,pointerSize:R=12,pathFilter:C="drop-shadow(0 3px 4px rgba(0,0,0,0.2))"}=n;super(t,{x:{value:s!=null&&o!=null?null:i,scale:"x",optional:!0},y:{value:a!=null&&c!=null?null:r,scale:"y",optional:!0},x1:{value:s,scale:"x",optional:o==null},y1:{value:a,scale:"y",optional:c==null},x2:{value:o,scale:"x",optional:s==null},y2:{value:c,scale:"y",optional:a==null},title:{value:M,optional:!0}},n,Ny),this.anchor=Kh(l,"anchor"),this.preferredAnchor=Kh(u,"preferredAnchor"),this.frameAnchor=xs(S),this.textAnchor=Re(w,"middle"),this.textPadding=+y,this.pointerSize=+R,this.pathFilter=Pe(C),this.lineHeight=+m,this.lineWidth=+x,this.textOverflow=_y(b),this.monospace=!!h,this.fontFamily=Pe(f),this.fontSize=Ie(d),this.fontStyle=Pe(p),this.fontVariant=Pe(_),this.fontWeight=Pe(g);for(let E in Ny)E in this.channels&&(this[E]=Ny[E]);this.splitLines=by(this),this.clipLine=My(this),this.format=typeof v=="string"||typeof v=="function"?{title:v}:{...v}}render(t,n,i,r,s){let o=this,{x:a,y:c,fx:l,fy:u}=n,{ownerSVGElement:h,document:f}=s,{anchor:d,monospace:p,lineHeight:_,lineWidth:g}=this,{textPadding:m,pointerSize:x,pathFilter:S}=this,{marginTop:v,marginLeft:w}=r,{x1:b,y1:y,x2:M,y2:R,x:C=b??M,y:E=y??R}=i,N=l?l(t.fx)-w:0,k=u?u(t.fy)-v:0,[P,L]=sr(this,r),B=oy(i,P),U=ay(i,L),Z=p?_d:gd,F=Z(uo),G,q;"title"in i?(G=AE.call(this,{title:i.channels.title},n),q=A5):(G=AE.call(this,i.channels,n),q=E5);let rt=ae("svg:g",s).call(Ve,this,r,s).call(vy,this).call(He,this,{x:C&&a,y:E&&c}).call(ot=>ot.selectAll().data(t).enter().append("g").attr("transform",ut=>`translate(${Math.round(B(ut))},${Math.round(U(ut))})`).call(Le,this).call(ut=>ut.append("path").attr("filter",S)).call(ut=>ut.append("text").each(function(st){let at=Ti(this);this.setAttribute("fill","currentColor"),this.setAttribute("fill-opacity",1),this.setAttribute("stroke","none");let J=q.call(o,st,t,G,n,i);if(typeof J=="string")for(let yt of o.splitLines(J))ct(at,{value:o.clipLine(yt)});else{let yt=new Set;for(let lt of J){let{label:K=""}=lt;K&&yt.has(K)||(yt.add(K),ct(at,lt))}}})));function ct(ot,{label:ut,value:st,color:at,opacity:J}){ut??(ut=""),st??(st="");let yt=at!=null||J!=null,lt,K=g*100,[Lt]=fo(ut,K,Z,F);if(Lt>=0)ut=ut.slice(0,Lt).trimEnd()+uo,lt=st.trim(),st="";else{(ut||!st&&!yt)&&(st=" "+st);let[Vt]=fo(st,K-Z(ut),Z,F);Vt>=0&&(lt=st.trim(),st=st.slice(0,Vt).trimEnd()+uo)}let Mt=ot.append("tspan").attr("x",0).attr("dy",`${_}em`).text("\u200B");ut&&Mt.append("tspan").attr("font-weight","bold").text(ut),st&&Mt.append(()=>f.createTextNode(st)),yt&&Mt.append("tspan").text(" \u25A0").attr("fill",at).attr("fill-opacity",J).style("user-select","none"),lt&&Mt.append("title").text(lt)}function $(){let{width:ot,height:ut}=r.facet??r;rt.selectChildren().each(function(st){let{x:at,width:J,height:yt}=this.getBBox();J=Math.round(J),yt=Math.round(yt);let lt=d;if(lt===void 0){let Mt=B(st)+N,Vt=U(st)+k,Xt=Mt+J+x+m*2<ot,he=Mt-J-x-m*2>0,ce=Vt+yt+x+m*2<ut,un=Vt-yt-x-m*2>0;lt=Xt&&he?ce&&un?o.preferredAnchor:un?"bottom":"top":ce&&un?Xt?"left":"right":(Xt||he)&&(ce||un)?`${un?"bottom":"top"}-${Xt?"left":"right"}`:o.preferredAnchor}let K=this.firstChild,Lt=this.lastChild;if(K.setAttribute("d",T5(lt,x,m,J,yt)),at)for(let Mt of Lt.childNodes)Mt.setAttribute("x",-at);Lt.setAttribute("y",`${+S5(lt,Lt.childNodes.length,_).toFixed(6)}em`),Lt.setAttribute("transform",`translate(${w5(lt,x,m,J,yt)})`)}),rt.attr("visibility",null)}return t.length&&(rt.attr("visibility","hidden"),h.isConnected?Promise.resolve().then($):typeof requestAnimationFrame<"u"&&requestAnimationFrame($)),rt.node()}};function Pl(e,{x:t,y:n,...i}={}){return i.frameAnchor===void 0&&([t,n]=Nr(t,n)),new wd(e,{...i,x:t,y:n})}function S5(e,t,n){return/^top(?:-|$)/.test(e)?.94-n:-.29-t*n}function w5(e,t,n,i,r){switch(e){case"middle":return[-i/2,r/2];case"top-left":return[n,t+n];case"top":return[-i/2,t/2+n];case"top-right":return[-i-n,t+n];case"right":return[-t/2-i-n,r/2];case"bottom-left":return[n,-t-n];case"bottom":return[-i/2,-t/2-n];case"bottom-right":return[-i-n,-t-n];case"left":return[n+t/2,r/2]}}function T5(e,t,n,i,r){let s=i+n*2,o=r+n*2;switch(e){case"middle":return`M${-s/2},${-o/2}h${s}v${o}h${-s}z`;case"top-left":return`M0,0l${t},${t}h${s-t}v${o}h${-s}z`;case"top":return`M0,0l${t/2},${t/2}h${(s-t)/2}v${o}h${-s}v${-o}h${(s-t)/2}z`;case"top-right":return`M0,0l${-t},${t}h${t-s}v${o}h${s}z`;case"right":return`M0,0l${-t/2},${-t/2}v${t/2-o/2}h${-s}v${o}h${s}v${t/2-o/2}z`;case"bottom-left":return`M0,0l${t},${-t}h${s-t}v${-o}h${-s}z`;case"bottom":return`M0,0l${t/2},${-t/2}h${(s-t)/2}v${-o}h${-s}v${o}h${(s-t)/2}z`;case"bottom-right":return`M0,0l${-t},${-t}h${t-s}v${-o}h${s}z`;case"left":return`M0,0l${t/2},${-t/2}v${t/2-o/2}h${s}v${o}h${-s}v${t/2-o/2}z`}}function AE(e,t){let n={},i=this.format;i=EE(i,e,"x"),i=EE(i,e,"y"),this.format=i;for(let r in i){let s=i[r];if(!(s===null||s===!1))if(r==="fx"||r==="fy")n[r]=!0;else{let o=F_(e,r);o&&(n[r]=o)}}for(let r in e){if(r in n||r in i||M5.has(r)||(r==="x"||r==="y")&&e.geometry)continue;let s=F_(e,r);if(s){if(s.scale==null&&s.defaultScale==="color")continue;n[r]=s}}this.facet&&(t.fx&&!("fx"in i)&&(n.fx=!0),t.fy&&!("fy"in i)&&(n.fy=!0));for(let r in n){let s=this.format[r];if(typeof s=="string"){let o=n[r]?.value??t[r]?.domain()??[];this.format[r]=(je(o)?Ji:Wi)(s)}else if(s===void 0||s===!0){let o=t[r];this.format[r]=o?.bandwidth?Al(o,o.domain()):rr}}return n}function EE(e,t,n){if(!(n in e))return e;let i=`${n}1`,r=`${n}2`;if((i in e||!(i in t))&&(r in e||!(r in t)))return e;let s=Object.entries(e),o=e[n];return s.splice(s.findIndex(([a])=>a===n)+1,0,[i,o],[r,o]),Object.fromEntries(s)}function A5(e,t,{title:n}){return this.format.title(n.value[e],e)}function*E5(e,t,n,i,r){for(let s in n){if(s==="fx"||s==="fy"){yield{label:Td(i,n,s),value:this.format[s](t[s],e)};continue}if(s==="x1"&&"x2"in n||s==="y1"&&"y2"in n)continue;let o=n[s];if(s==="x2"&&"x1"in n)yield{label:RE(i,n,"x"),value:CE(this.format.x2,n.x1,o,e)};else if(s==="y2"&&"y1"in n)yield{label:RE(i,n,"y"),value:CE(this.format.y2,n.y1,o,e)};else{let a=o.value[e],c=o.scale;if(!hi(a)&&c==null)continue;yield{label:Td(i,n,s),value:this.format[s](a,e),color:c==="color"?r[s][e]:null,opacity:c==="opacity"?r[s][e]:null}}}}function CE(e,t,n,i){return n.hint?.length?`${e(n.value[i]-t.value[i],i)}`:`${e(t.value[i],i)}\u2013${e(n.value[i],i)}`}function RE(e,t,n){let i=Td(e,t,`${n}1`,n),r=Td(e,t,`${n}2`,n);return i===r?i:`${i}\u2013${r}`}function Td(e,t,n,i=n){let r=t[n],s=e[r?.scale??n];return String(s?.label??r?.label??i)}function Ll(e={}){let{facet:t,style:n,title:i,subtitle:r,caption:s,ariaLabel:o,ariaDescription:a}=e,c=Da(e.className),l=e.marks===void 0?[]:IE(e.marks);l.push(...N5(l));let u=I5(t,e),h=new Map;for(let F of l){let G=LE(F,u,e);G&&h.set(F,G)}let f=new Map;u&&Il(f,[u],e),Il(f,h,e);let d=IE(D5(l,f,e));for(let F of d){let G=LE(F,u,e);G&&h.set(F,G)}l.unshift(...d);let p=YT(f,e);if(p!==void 0){let F=u?od(p,u):void 0;for(let q of l){if(q.facet===null||q.facet==="super")continue;let rt=h.get(q);rt!==void 0&&(rt.facetsIndex=q.fx!=null||q.fy!=null?od(p,rt):F)}let G=new Set;for(let{facetsIndex:q}of h.values())q?.forEach((rt,ct)=>{rt?.length>0&&G.add(ct)});p.forEach(0<G.size&&G.size<p.length?(q,rt)=>q.empty=!G.has(rt):q=>q.empty=!1);for(let q of l)if(q.facet==="exclude"){let rt=h.get(q);rt!==void 0&&(rt.facetsIndex=KT(rt.facetsIndex))}}for(let F of pe.keys())Ma(e[F])&&F!=="fx"&&F!=="fy"&&f.set(F,[]);let _=new Map;for(let F of l){if(_.has(F))throw new Error("duplicate mark; each mark must be unique");let{facetsIndex:G,channels:q}=h.get(F)??{},{data:rt,facets:ct,channels:$}=F.initialize(G,q,e);Fy($,e),_.set(F,{data:rt,facets:ct,channels:$})}let g=vl(Il(f,_,e),e),m=pA(g,l,e);VT(g,m);let x=X_(g),{fx:S,fy:v}=x,w=S||v?q_(g,m):m,b=S||v?G5(x,m):m,y=Na(e),M=y.document,R=Qo("svg").call(M.documentElement),C=R;y.ownerSVGElement=R,y.className=c,y.projection=tA(e,w),y.path=function(){return Qc(this.projection??oA(x))},y.filterFacets=(F,G)=>od(p,{channels:G,groups:rd(F,G)}),y.getMarkState=F=>{let G=_.get(F),q=h.get(F);return{...G,channels:{...G.channels,...q?.channels}}},y.dispatchValue=F=>{C.value!==F&&(C.value=F,C.dispatchEvent(new y.document.defaultView.Event("input",{bubbles:!0})))};let E=new Set;for(let[F,G]of _)if(F.initializer!=null){let q=F.facet==="super"?b:w,rt=F.initializer(G.data,G.facets,G.channels,x,q,y);if(rt.data!==void 0&&(G.data=rt.data),rt.facets!==void 0&&(G.facets=rt.facets),rt.channels!==void 0){let{fx:ct,fy:$,...ot}=rt.channels;P5(ot),Object.assign(G.channels,ot);for(let ut of Object.values(ot)){let{scale:st}=ut;st!=null&&!Vw(pe.get(st))&&(UE(ut,e),E.add(st))}(ct!=null||$!=null)&&h.set(F,!0)}}if(E.size){let F=new Map;Il(F,_,e,ct=>E.has(ct)),Il(f,_,e,ct=>E.has(ct));let G=z5(vl(F,e),g),{scales:q,...rt}=X_(G);Object.assign(g,G),Object.assign(x,rt),Object.assign(x.scales,q)}let N,k;p!==void 0&&(N={x:S?.domain(),y:v?.domain()},p=ZT(p,N),k=JT(S,v,m));for(let[F,G]of _)G.values=F.scale(G.channels,x,y);let{width:P,height:L}=m;Ti(R).attr("class",c).attr("fill","currentColor").attr("font-family","system-ui, sans-serif").attr("font-size",10).attr("text-anchor","middle").attr("width",P).attr("height",L).attr("viewBox",`0 0 ${P} ${L}`).attr("aria-label",o).attr("aria-description",a).call(F=>F.append("style").text(`:where(.${c}) {
  --plot-background: white;
  display: block;
  height: auto;
  height: intrinsic;
  max-width: 100%;
}
:where(.${c} text),
:where(.${c} tspan) {
  white-space: pre;
}`)).call(Ua,n);for(let F of l){let{channels:G,values:q,facets:rt}=_.get(F);if(p===void 0||F.facet==="super"){let ct=null;if(rt&&(ct=rt[0],ct=F.filter(ct,G,q),ct.length===0))continue;let $=F.render(ct,x,q,b,y);if($==null)continue;R.appendChild($)}else{let ct;for(let $ of p){if(!(F.facetAnchor?.(p,N,$)??!$.empty))continue;let ot=null;if(rt){let st=h.has(F);if(ot=rt[st?$.i:0],ot=F.filter(ot,G,q),ot.length===0)continue;!st&&ot===rt[0]&&(ot=Ew(ot)),ot.fx=$.x,ot.fy=$.y,ot.fi=$.i}let ut=F.render(ot,x,q,w,y);if(ut!=null){(ct??(ct=Ti(R).append("g"))).append(()=>ut).datum($);for(let st of["aria-label","aria-description","aria-hidden","transform"])ut.hasAttribute(st)&&(ct.attr(st,ut.getAttribute(st)),ut.removeAttribute(st))}}ct?.selectChildren().each(k)}}let B=mE(g,y,e),{figure:U=i!=null||r!=null||s!=null||B.length>0}=e;U&&(C=M.createElement("figure"),C.className=`${c}-figure`,C.style.maxWidth="initial",i!=null&&C.append(PE(M,i,"h2")),r!=null&&C.append(PE(M,r,"h3")),C.append(...B,R),s!=null&&C.append(C5(M,s)),"value"in R&&(C.value=R.value,delete R.value)),C.scale=XT(x.scales),C.legend=hE(g,y,e);let Z=ST();return Z>0&&Ti(R).append("text").attr("x",P).attr("y",20).attr("dy","-1em").attr("text-anchor","end").attr("font-family","initial").text("\u26A0\uFE0F").append("title").text(`${Z.toLocaleString("en-US")} warning${Z===1?"":"s"}. Please check the console.`),C}function PE(e,t,n){if(t.ownerDocument)return t;let i=e.createElement(n);return i.append(t),i}function C5(e,t){let n=e.createElement("figcaption");return n.append(t),n}function IE(e){return e.flat(1/0).filter(t=>t!=null).map(R5)}function R5(e){return typeof e.render=="function"?e:new Uy(e)}var Uy=class extends xe{constructor(t){if(typeof t!="function")throw new TypeError("invalid mark; missing render function");super(),this.render=t}render(){}};function Fy(e,t){for(let n in e)UE(e[n],t);return e}function UE(e,t){let{scale:n,transform:i=!0}=e;if(n==null||!i)return;let{type:r,percent:s,interval:o,transform:a=s?c=>c==null?NaN:c*100:A_(o,r)}=t[n]??{};a!=null&&(e.value=ye(e.value,a),e.transform=!1)}function P5(e){for(let t in e)U_(t,e[t])}function Il(e,t,n,i=Sw){for(let{channels:r}of t.values())for(let s in r){let o=r[s],{scale:a}=o;if(a!=null&&i(a))if(a==="projection"){if(!iA(n)){let c=n.x?.domain===void 0,l=n.y?.domain===void 0;if(c||l){let[u,h]=sA(o);c&&Dy(e,"x",u),l&&Dy(e,"y",h)}}}else Dy(e,a,o)}return e}function Dy(e,t,n){let i=e.get(t);i!==void 0?i.push(n):e.set(t,[n])}function I5(e,t){if(e==null)return;let{x:n,y:i}=e;if(n==null&&i==null)return;let r=Lr(e.data);if(r==null)throw new Error("missing facet data");let s={};n!=null&&(s.fx=Ea(r,{value:n,scale:"fx"})),i!=null&&(s.fy=Ea(r,{value:i,scale:"fy"})),Fy(s,t);let o=rd(r,s);return{channels:s,groups:o,data:e.data}}function LE(e,t,n){if(e.facet===null||e.facet==="super")return;let{fx:i,fy:r}=e;if(i!=null||r!=null){let c=Lr(e.data??i??r);if(c===void 0)throw new Error(`missing facet data in ${e.ariaLabel}`);if(c===null)return;let l={};return i!=null&&(l.fx=Ea(c,{value:i,scale:"fx"})),r!=null&&(l.fy=Ea(c,{value:r,scale:"fy"})),Fy(l,n),{channels:l,groups:rd(c,l)}}if(t===void 0)return;let{channels:s,groups:o,data:a}=t;if(e.facet!=="auto"||e.data===a)return{channels:s,groups:o};a.length>0&&(o.size>1||o.size===1&&s.fx&&s.fy&&[...o][0][1].size>1)&&ms(Lr(e.data))===ms(a)&&Dn(`Warning: the ${e.ariaLabel} mark appears to use faceted data, but isn\u2019t faceted. The mark data has the same length as the facet data and the mark facet option is "auto", but the mark data and facet data are distinct. If this mark should be faceted, set the mark facet option to true; otherwise, suppress this warning by setting the mark facet option to false.`)}function L5(e,t={}){return Dr({...t,x:null,y:null},(n,i,r,s,o,a)=>a.getMarkState(e))}function N5(e){let t=[];for(let n of e){let i=n.tip;if(i){i===!0?i={}:typeof i=="string"&&(i={pointer:i});let{pointer:r,preferredAnchor:s}=i;r=/^x$/i.test(r)?sy:/^y$/i.test(r)?ud:Ml,i=r(L5(n,i)),i.title=null,s===void 0&&(i.preferredAnchor=r===ud?"left":"bottom");let o=Pl(n.data,i);o.facet=n.facet,o.facetAnchor=n.facetAnchor,t.push(o)}}return t}function D5(e,t,n){let{projection:i,x:r={},y:s={},fx:o={},fy:a={},axis:c,grid:l,facet:u={},facet:{axis:h=c,grid:f}=u,x:{axis:d=c,grid:p=d===null?null:l}=r,y:{axis:_=c,grid:g=_===null?null:l}=s,fx:{axis:m=h,grid:x=m===null?null:f}=o,fy:{axis:S=h,grid:v=S===null?null:f}=a}=n;(i||!Ma(r)&&!NE("x",e))&&(d=p=null),(i||!Ma(s)&&!NE("y",e))&&(_=g=null),t.has("fx")||(m=x=null),t.has("fy")||(S=v=null),d===void 0&&(d=!Cd(e,"x")),_===void 0&&(_=!Cd(e,"y")),m===void 0&&(m=!Cd(e,"fx")),S===void 0&&(S=!Cd(e,"fy")),d===!0&&(d="bottom"),_===!0&&(_="left"),m===!0&&(m=d==="top"||d===null?"bottom":"top"),S===!0&&(S=_==="right"||_===null?"left":"right");let w=[];return Ed(w,v,JA,a),Ad(w,S,$A,"right","left",u,a),Ed(w,x,jA,o),Ad(w,m,XA,"top","bottom",u,o),Ed(w,g,ZA,s),Ad(w,_,wy,"left","right",n,s),Ed(w,p,KA,r),Ad(w,d,Ty,"bottom","top",n,r),w}function Ad(e,t,n,i,r,s,o){if(!t)return;let a=U5(t);o=F5(a?i:t,s,o);let{line:c}=o;(n===wy||n===Ty)&&c&&!oo(c)&&e.push(TE(O5(o))),e.push(n(o)),a&&e.push(n({...o,anchor:r,label:null}))}function Ed(e,t,n,i){!t||oo(t)||e.push(n(B5(t,i)))}function U5(e){return/^\s*both\s*$/i.test(e)}function F5(e,t,{line:n=t.line,ticks:i,tickSize:r,tickSpacing:s,tickPadding:o,tickFormat:a,tickRotate:c,fontVariant:l,ariaLabel:u,ariaDescription:h,label:f=t.label,labelAnchor:d,labelArrow:p=t.labelArrow,labelOffset:_}){return{anchor:e,line:n,ticks:i,tickSize:r,tickSpacing:s,tickPadding:o,tickFormat:a,tickRotate:c,fontVariant:l,ariaLabel:u,ariaDescription:h,label:f,labelAnchor:d,labelArrow:p,labelOffset:_}}function O5(e){let{anchor:t,line:n}=e;return{anchor:t,facetAnchor:t+"-empty",stroke:n===!0?void 0:n}}function B5(e,{stroke:t=wa(e)?e:void 0,ticks:n=k5(e)?e:void 0,tickSpacing:i,ariaLabel:r,ariaDescription:s}){return{stroke:t,ticks:n,tickSpacing:i,ariaLabel:r,ariaDescription:s}}function k5(e){switch(typeof e){case"number":return!0;case"string":return!wa(e)}return pi(e)||typeof e?.range=="function"}function Cd(e,t){let n=`${t}-axis `;return e.some(i=>i.ariaLabel?.startsWith(n))}function NE(e,t){for(let n of t)for(let i in n.channels){let{scale:r}=n.channels[i];if(r===e||r==="projection")return!0}return!1}function z5(e,t){for(let n in e){let i=e[n],r=t[n];i.label===void 0&&r&&(i.label=r.label)}return e}function G5({fx:e,fy:t},n){let{marginTop:i,marginRight:r,marginBottom:s,marginLeft:o,width:a,height:c}=nd(n),l=e&&DE(e),u=t&&DE(t);return{marginTop:t?u[0]:i,marginRight:e?a-l[1]:r,marginBottom:t?c-u[1]:s,marginLeft:e?l[0]:o,inset:{marginTop:n.marginTop,marginRight:n.marginRight,marginBottom:n.marginBottom,marginLeft:n.marginLeft},width:a,height:c}}function DE(e){let t=e.domain();if(t.length===0)return[0,e.bandwidth()];let n=e(t[0]),i=e(t[t.length-1]);return i<n&&([n,i]=[i,n]),[n,i+e.bandwidth()]}var V5=new Map([["basis",zS],["basis-closed",VS],["basis-open",WS],["bundle",XS],["bump-x",DS],["bump-y",US],["cardinal",qS],["cardinal-closed",YS],["cardinal-open",ZS],["catmull-rom",KS],["catmull-rom-closed",QS],["catmull-rom-open",ew],["linear",ga],["linear-closed",iw],["monotone-x",ow],["monotone-y",aw],["natural",lw],["step",uw],["step-after",hw],["step-before",fw]]);function H5(e=ga,t){if(typeof e=="function")return e;let n=V5.get(`${e}`.toLowerCase());if(!n)throw new Error(`unknown curve: ${e}`);if(t!==void 0){if("beta"in n)return n.beta(t);if("tension"in n)return n.tension(t);if("alpha"in n)return n.alpha(t)}return n}function FE(e=Nl,t){return typeof e!="function"&&`${e}`.toLowerCase()==="auto"?Nl:H5(e,t)}function Nl(e){return ga(e)}var W5={ariaLabel:"bar"},Oy=class extends xe{constructor(t,n,i={},r=W5){super(t,n,i,r),El(this,i),Cl(this,i)}render(t,n,i,r,s){let{rx:o,ry:a,rx1y1:c,rx1y2:l,rx2y1:u,rx2y2:h}=this,f=this._x(n,i,r),d=this._y(n,i,r),p=this._width(n,i,r),_=this._height(n,i,r);return ae("svg:g",s).call(Ve,this,r,s).call(this._transform,this,n).call(g=>g.selectAll().data(t).enter().call(c||l||u||h?m=>m.append("path").call(Le,this).call(Rl,f,d,OE(f,p),OE(d,_),this).call(ln,this,i):m=>m.append("rect").call(Le,this).attr("x",f).attr("width",p).attr("y",d).attr("height",_).call(Bt,"rx",o).call(Bt,"ry",a).call(ln,this,i))).node()}_x(t,{x:n},{marginLeft:i}){let{insetLeft:r}=this;return n?s=>n[s]+r:i+r}_y(t,{y:n},{marginTop:i}){let{insetTop:r}=this;return n?s=>n[s]+r:i+r}_width({x:t},{x:n},{marginRight:i,marginLeft:r,width:s}){let{insetLeft:o,insetRight:a}=this,c=n&&t?t.bandwidth():s-i-r;return Math.max(0,c-o-a)}_height({y:t},{y:n},{marginTop:i,marginBottom:r,height:s}){let{insetTop:o,insetBottom:a}=this,c=n&&t?t.bandwidth():s-i-r;return Math.max(0,c-o-a)}};function OE(e,t){return typeof e=="function"&&typeof t=="function"?n=>e(n)+t(n):typeof e=="function"?n=>e(n)+t:typeof t=="function"?n=>e+t(n):e+t}var Rd=class extends Oy{constructor(t,n={},i){let{x1:r,x2:s,y:o}=n;super(t,{x1:{value:r,scale:"x"},x2:{value:s,scale:"x"},y:{value:o,scale:"y",type:"band",optional:!0}},n,i)}_transform(t,n,{x:i}){t.call(He,n,{x:i},0,0)}_x({x:t},{x1:n,x2:i},{marginLeft:r}){let{insetLeft:s}=this;return Ri(t)?r+s:o=>Math.min(n[o],i[o])+s}_width({x:t},{x1:n,x2:i},{marginRight:r,marginLeft:s,width:o}){let{insetLeft:a,insetRight:c}=this;return Ri(t)?o-r-s-a-c:l=>Math.max(0,Math.abs(i[l]-n[l])-a-c)}};function By(e,t={}){return $h(t)||(t={...t,y:ro,x2:be}),new Rd(e,Ry(dd(Ey(t))))}var $5={ariaLabel:"dot",fill:"none",stroke:"currentColor",strokeWidth:1.5};function X5(e){return e.sort===void 0&&e.reverse===void 0?Yw({channel:"-r"},e):e}var Pd=class extends xe{constructor(t,n={}){let{x:i,y:r,r:s,rotate:o,symbol:a=to,frameAnchor:c}=n,[l,u]=Ce(o,0),[h,f]=$w(a),[d,p]=Ce(s,h==null?3:4.5);super(t,{x:{value:i,scale:"x",optional:!0},y:{value:r,scale:"y",optional:!0},r:{value:d,scale:"r",filter:no,optional:!0},rotate:{value:l,optional:!0},symbol:{value:h,scale:"auto",optional:!0}},X5(n),$5),this.r=p,this.rotate=u,this.symbol=f,this.frameAnchor=xs(c);let{channels:_}=this,{symbol:g}=_;if(g){let{fill:m,stroke:x}=_;g.hint={fill:m?m.value===g.value?"color":"currentColor":this.fill??"currentColor",stroke:x?x.value===g.value?"color":"currentColor":this.stroke??"none"}}}render(t,n,i,r,s){let{x:o,y:a}=n,{x:c,y:l,r:u,rotate:h,symbol:f}=i,{r:d,rotate:p,symbol:_}=this,[g,m]=sr(this,r),x=_===to,S=u?void 0:d*d*Math.PI;return _a(d)&&(t=[]),ae("svg:g",s).call(Ve,this,r,s).call(He,this,{x:c&&o,y:l&&a}).call(v=>v.selectAll().data(t).enter().append(x?"circle":"path").call(Le,this).call(x?w=>{w.attr("cx",c?b=>c[b]:g).attr("cy",l?b=>l[b]:m).attr("r",u?b=>u[b]:d)}:w=>{w.attr("transform",Oa`translate(${c?b=>c[b]:g},${l?b=>l[b]:m})${h?b=>` rotate(${h[b]})`:p?` rotate(${p})`:""}`).attr("d",u&&f?b=>{let y=Hi();return f[b].draw(y,u[b]*u[b]*Math.PI),y}:u?b=>{let y=Hi();return _.draw(y,u[b]*u[b]*Math.PI),y}:f?b=>{let y=Hi();return f[b].draw(y,S),y}:(()=>{let b=Hi();return _.draw(b,S),b})())}).call(ln,this,i)).node()}};function ky(e,{x:t,y:n,...i}={}){return i.frameAnchor===void 0&&([t,n]=Nr(t,n)),new Pd(e,{...i,x:t,y:n})}var q5={ariaLabel:"line",fill:"none",stroke:"currentColor",strokeWidth:1.5,strokeLinecap:"round",strokeLinejoin:"round",strokeMiterlimit:1},Id=class extends xe{constructor(t,n={}){let{x:i,y:r,z:s,curve:o,tension:a}=n;super(t,{x:{value:i,scale:"x"},y:{value:r,scale:"y"},z:{value:Xh(n),optional:!0}},n,q5),this.z=s,this.curve=FE(o,a),Sl(this,n)}filter(t){return t}project(t,n,i){this.curve!==Nl&&super.project(t,n,i)}render(t,n,i,r,s){let{x:o,y:a}=i,{curve:c}=this;return ae("svg:g",s).call(Ve,this,r,s).call(He,this,n).call(l=>l.selectAll().data(fA(t,[o,a],this,i)).enter().append("path").call(Le,this).call(uA,this,i).call(xA,this,i,s).attr("d",c===Nl&&s.projection?Y5(s.path(),o,a):LS().curve(c).defined(u=>u>=0).x(u=>o[u]).y(u=>a[u]))).node()}};function Y5(e,t,n){return t=so(t),n=so(n),i=>{let r=[],s=[r];for(let o of i)o===-1?(r=[],s.push(r)):r.push([t[o],n[o]]);return e({type:"MultiLineString",coordinates:s})}}function zy(e,{x:t,y:n,...i}={}){return[t,n]=Nr(t,n),new Id(e,{...i,x:t,y:n})}xe.prototype.plot=function({marks:e=[],...t}={}){return Ll({...t,marks:[...e,this]})};return YE(Z5);})();
